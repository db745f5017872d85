// SPDX-License-Identifier: Apache-2.0
#include "scene/body_matrix.h"
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"

namespace poinsot::scene {
namespace {

using enum ValueType;

constexpr Range kTypeFactor{.least = 0.1, .most = 10};

std::vector<std::string_view> spotWords() {  // names of the enumerators of Spot, in their order
  return {"top left", "top", "top right", "left", "centre", "right", "bottom left", "bottom", "bottom right"};
}

template <class F>
Put intoReadout(F place) {
  return into([place](Draft& d, std::size_t i) { return place(elementAt(d.readouts, i)); });
}

template <class F>
Put intoNote(F place) {
  return into([place](Draft& d, std::size_t i) { return place(elementAt(d.notes, i)); });
}

std::vector<Key> readoutKeys() {
  return {
      {.path = "readout[].quantity",
       .type = kWord,
       .words = quantityWords(),
       .wordList = "quantities",
       .example = "\"t\"",
       .help = "Quantity whose value is written, with its unit, at every instant of the film.",
       .put = intoReadout([](Readout& r) { return &r.quantity; })},
      {.path = "readout[].at",
       .type = kWord,
       .words = spotWords(),
       .example = "\"bottom left\"",
       .help = "Place of the read-out in the picture. The default is the top right. Several read-outs at the same "
               "place stand under one another.",
       .put = intoReadout([](Readout& r) { return &r.at; })},
      {.path = "readout[].label",
       .type = kText,
       .range = {.least = 0, .most = 200},
       .example = "'$\\omega_{\\mathrm{spin}}$'",
       .help = "Text before the equals sign. By default, the quantity's symbol.",
       .isTex = true,
       .put = intoReadout([](Readout& r) { return &r.label; })},
      {.path = "readout[].unit",
       .type = kText,
       .range = {.least = 0, .most = kLongestUnit},
       .example = "\"ms\"",
       .help = "Unit of the read-out's value. By default, poinsot chooses a unit that suits the numbers.",
       .put = intoReadout([](Readout& r) { return &r.unit; })},
  };
}

std::vector<Key> textKeys() {
  return {
      {.path = "note[].text",
       .type = kLines,
       .range = {.least = 0, .most = 200},
       .example = "'$\\mathbf{L} = I\\,\\boldsymbol{\\omega}$'",
       .help = "Text of the note, such as a caption or an equation. The text does not change during the film. For "
               "several lines, give an array of lines, or end each line with a line break.",
       .isTex = true,
       .put = intoNote([](Note& n) { return &n.lines; })},
      {.path = "note[].matrix",
       .type = kWord,
       .words = bodyMatrixWords(),
       .example = "\"inertia\"",
       .help =
           "Matrix of the body that the note shows, with its numbers. `inertia` is the inertia tensor about the "
           "point that the body turns about, along the body's axes. `inertia_centre` is the tensor about the "
           "centre of mass, and `inertia_displacement` is what eq 14 of docs/physics.md adds to it for "
           "body.pivot. `inertia_principal` and `inertia_own` are the tensor along the principal axes and "
           "along [body.own_axes]. `U_principal` and `U_own` are the matrices U of eq 15, whose rows are these "
           "axes. With `matrix`, `text` is the name before the equals sign, and may be left out.",
       .put = intoNote([](Note& n) { return &n.matrix; })},
      {.path = "note[].at",
       .type = kWord,
       .words = spotWords(),
       .example = "\"left\"",
       .help = "Place of the note in the picture. The default is the bottom. If a note and a read-out have the "
               "same place, the note stands above the read-out.",
       .put = intoNote([](Note& n) { return &n.at; })},
      {.path = "note[].size",
       .range = kTypeFactor,
       .example = "1.5",
       .help = "Factor on the size of the note's text, in addition to style.text_size. The default is 1.",
       .put = intoNote([](Note& n) { return &n.size; })},
  };
}

}  // namespace

std::vector<Key> noteKeys() { return joined({readoutKeys(), textKeys()}); }

}  // namespace poinsot::scene
