// SPDX-License-Identifier: Apache-2.0
#include "describe/language.h"

#include <map>
#include <utility>

#include "core/expect.h"

namespace poinsot::describe {
namespace {

constexpr Translation kGerman[] = {
    // values
    {" and ", " und "},
    {" by ", " mal "},
    {"an infinite time", "unendlich lange"},
    {"{} minutes", "{} Minuten"},
    {"{} hours", "{} Stunden"},
    {"{} days", "{} d"},  // "Tage" would be "Tagen" after "in"
    {"{}, {} turns a second", "{}, {} Umdrehungen je Sekunde"},
    {"{}, one turn in {}", "{}, eine Umdrehung in {}"},

    // the body
    {"{} of radius {}", "{} mit Radius {}"},
    {"{} and height {}", "{} und Höhe {}"},
    {"a box of {}", "ein Quader von {}"},
    {"a hollow box of {}", "ein hohler Quader von {}"},
    {"a thin plate of {}", "eine dünne Platte von {}"},
    {"an ellipsoid of {}", "ein Ellipsoid von {}"},
    {"a hollow ellipsoid of {}", "ein hohles Ellipsoid von {}"},
    {"an L-shaped plate of {}", "eine L-förmige Platte von {}"},
    {"a hollow sphere", "eine Hohlkugel"},
    {"a sphere", "eine Kugel"},
    {"a spherical shell", "eine Kugelschale"},
    {"a hemisphere", "eine Halbkugel"},
    {"a tube", "ein Rohr"},
    {"a cylinder", "ein Zylinder"},
    {"an open cylindrical shell", "ein offener Zylindermantel"},
    {"a thin disc", "eine dünne Scheibe"},
    {"a hoop", "ein Reifen"},
    {"a thin rod of length {}", "ein dünner Stab der Länge {}"},
    {"a cone", "ein Kegel"},
    {"a hollow cone", "ein hohler Kegel"},
    {"a torus", "ein Torus"},
    {"a hollow torus", "ein hohler Torus"},
    {"a capsule", "eine Kapsel"},
    {"{} of edge {}", "{} mit Kante {}"},
    {"a tetrahedron", "ein Tetraeder"},
    {"a cube", "ein Würfel"},
    {"an octahedron", "ein Oktaeder"},
    {"a dodecahedron", "ein Dodekaeder"},
    {"an icosahedron", "ein Ikosaeder"},
    {"a T-handle with a bar of {} and a shaft of {}",
     "ein T-Griff mit einem Balken von {} und einem Stiel von {}"},
    {"a racket, {} long and {} wide", "ein Schläger, {} lang und {} breit"},
    {"a wing nut with a hub of radius {}", "eine Flügelmutter mit einer Nabe vom Radius {}"},
    {"a body read from a mesh", "ein Körper aus einem Dreiecksnetz"},
    {"a point mass", "eine Punktmasse"},
    {"made of {} parts", "aus {} Teilen zusammengesetzt"},
    {"made of {}", "zusammengesetzt: {}"},
    {"{} kg m² about {}{}", "{} kg m² um {}{}"},
    {" about that point", " um diesen Punkt"},
    {"Its moment of inertia{} is {} kg m² about every axis.",
     "Sein Trägheitsmoment{} beträgt {} kg m² um jede Achse."},
    {"Its principal moments of inertia{} are {}.", "Seine Hauptträgheitsmomente{} sind {}."},
    {", and is drawn in another shape", ", und ist in anderer Form gezeichnet"},
    {", and is drawn as the uniform box that has them",
     ", und ist als der homogene Quader gezeichnet, der sie hat"},
    {", and is drawn as the uniform cone that has them",
     ", und ist als der homogene Kegel gezeichnet, der sie hat"},
    {"given by its moments of inertia", "durch seine Trägheitsmomente gegeben"},
    {"given by its moments of inertia alone", "allein durch seine Trägheitsmomente gegeben"},
    {", of {} kg", ", {} kg schwer"},
    {", and turns about a point that is held fixed", ", und dreht sich um einen festgehaltenen Punkt"},
    {"The body is {}.", "Der Körper ist {}."},

    // free motion
    {": in space it points straight down", ": im Raum zeigt er senkrecht nach unten"},
    {": in space it points straight up", ": im Raum zeigt er senkrecht nach oben"},
    {"{}, so its angular momentum L{}, of {} kg m²/s, never changes{}.",
     "{}, also ändert sich sein Drehimpuls L{}, vom Betrag {} kg m²/s, nie{}."},
    {"Only its weight acts on the body, at the centre of mass",
     "Auf den Körper wirkt nur sein Gewicht, im Schwerpunkt"},
    {"Nothing acts on the body", "Auf den Körper wirkt nichts"},
    {"It spins steadily at {}: ω keeps its size and its direction.",
     "Er dreht sich stetig mit {}: ω behält Betrag und Richtung."},
    {" But this spin, about the middle axis {}, is unstable: the smallest disturbance grows by a factor of e "
     "every "
     "{}, until the body flips.",
     " Aber diese Drehung um die mittlere Achse {} ist instabil: die kleinste Störung wächst um den Faktor e in "
     "je "
     "{}, bis der Körper kippt."},
    {"It turns at {}, with a wobble: the symmetry axis {} leans from L by {} and goes round L once in {}, and so "
     "does ω, which makes {} with the axis.",
     "Er dreht sich mit {} und taumelt dabei: die Symmetrieachse {} ist um {} gegen L geneigt und umläuft L "
     "einmal "
     "in {}, ebenso ω, das mit der Achse einen Winkel von {} bildet."},
    {"Seen from the body, ω goes round the axis once in {}, in the {} the spin. The axis, ω and L lie in one "
     "plane at "
     "every instant.",
     "Vom Körper aus gesehen umläuft ω die Achse einmal in {}, {} der Drehung. Achse, ω und L liegen in jedem "
     "Augenblick in einer Ebene."},
    {"sense of", "im Sinn"},
    {"sense opposite to", "entgegen dem Sinn"},
    {"{}, the axis of {} moment", "{}, die Achse des {} Moments"},
    {"smallest", "kleinsten"},
    {"largest", "größten"},
    {"It starts at {} exactly on the separatrix: ω approaches the middle axis {} and never gets there, and the "
     "body "
     "turns over once.",
     "Er beginnt mit {} genau auf der Separatrix: ω nähert sich der mittleren Achse {}, ohne sie je zu erreichen, "
     "und "
     "der Körper kippt einmal um."},
    {"Every {} the body flips: its middle axis {}, which between flips comes within {} of the line of L, swings "
     "over "
     "to the opposite direction.",
     "Alle {} kippt der Körper um: seine mittlere Achse {}, die dazwischen bis auf {} an die Gerade von L "
     "herankommt, "
     "schwingt in die Gegenrichtung."},
    {"It starts at {}, and ω is not constant: once in {} its tip runs along the polhode, a closed curve in the "
     "body, "
     "round {}",
     "Er beginnt mit {}, und ω ist nicht konstant: einmal in {} läuft seine Spitze auf der Polhodie, einer "
     "geschlossenen Kurve im Körper, um {}"},
    {"; that axis leans from L by {} at most", "; diese Achse ist höchstens um {} gegen L geneigt"},
    {"In space the tip of ω draws the herpolhode, on the invariable plane, between {} and {} from the line of L",
     "Im Raum zeichnet die Spitze von ω die Herpolhodie auf die invariable Ebene, zwischen {} und {} von der "
     "Geraden "
     "von L entfernt"},
    {"; it closes after {} swings, in {} turns about L and {}",
     "; sie schließt sich nach {} Schwingungen, in {} Umläufen um L und {}"},
    {"Nothing acts on it, and it does not turn.", "Auf ihn wirkt nichts, und er dreht sich nicht."},

    // driven motion
    {"keeps an angle of {} with the vertical", "behält einen Winkel von {} zur Senkrechten"},
    {"rises from {} towards {}", "richtet sich von {} bis gegen {} auf"},
    {"nods between {} and {} from the vertical, once in {} (nutation), and goes round the vertical by {} each "
     "time "
     "(precession)",
     "nickt zwischen {} und {} von der Senkrechten, einmal in {} (Nutation), und umläuft dabei die Senkrechte um "
     "je {} "
     "(Präzession)"},
    {"Gravity pulls at the centre of mass and turns L; the vertical component of L stays constant.",
     "Die Schwerkraft greift im Schwerpunkt an und dreht L; die senkrechte Komponente von L bleibt konstant."},
    {"It is a cone that rolls on a level table without slipping; its apex stays at one point.",
     "Er ist ein Kegel, der auf einem ebenen Tisch rollt, ohne zu gleiten; seine Spitze bleibt an einem Ort."},
    {"Its axis goes round the vertical once in {}, and the cone turns about the line on which it touches the "
     "table, "
     "which is at rest, at {}.",
     "Seine Achse geht in {} einmal um die Senkrechte, und der Kegel dreht sich um die ruhende Linie, auf der er "
     "den "
     "Tisch berührt, mit {}."},
    {"Its axis {}.", "Seine Achse {}."},
    {"an axis across {}", "eine Achse quer zu {}"},
    {"{}, the axis of largest moment", "{}, die Achse des größten Moments"},
    {"It loses energy inside, but not angular momentum", "Er verliert im Innern Energie, aber keinen Drehimpuls"},
    {": L, of {} kg m²/s, never changes, and the motion tends to a steady spin about {}, at {}.",
     ": L, vom Betrag {} kg m²/s, ändert sich nie, und die Bewegung strebt einer stetigen Drehung um {} zu, mit "
     "{}."},
    {"Drag slows it down, about some axes more than about others.",
     "Reibung bremst ihn, um manche Achsen mehr als um andere."},
    {"Drag slows its spin to 1/e in {}.", "Reibung bremst seine Drehung in {} auf 1/e."},
    {"A torque that changes with time acts on it, {}.",
     "Ein zeitlich veränderliches Drehmoment wirkt auf ihn, {}."},
    {"A constant torque of {} N m acts on it, {}.", "Ein konstantes Drehmoment von {} N m wirkt auf ihn, {}."},
    {" from {}", " von {}"},
    {" until {}", " bis {}"},
    {"A force of {} N, {}, acts at a point of the body{}.",
     "Eine Kraft von {} N, {}, greift an einem Punkt des Körpers an{}."},
    {"fixed in the body", "fest im Körper"},
    {"fixed in space", "fest im Raum"},
    {"At the start it turns at {}.", "Am Anfang dreht er sich mit {}."},
    {"{} m/s", "{} m/s"},
    {"Its centre of mass moves at {} at the start, and the forces change this velocity.",
     "Sein Schwerpunkt bewegt sich am Anfang mit {}, und die Kräfte ändern diese Geschwindigkeit."},
    {"Its centre of mass moves at {} at the start, and the forces and its weight change this velocity.",
     "Sein Schwerpunkt bewegt sich am Anfang mit {}, und die Kräfte und sein Gewicht ändern diese "
     "Geschwindigkeit."},
    {"Its centre of mass flies straight on at {}.", "Sein Schwerpunkt fliegt geradeaus mit {}."},
    {", which rises {1} m in {0}", ", die in {0} um {1} m steigt"},
    {"It is thrown at {}: its centre of mass flies on a parabola{}, while the body turns about this point as if "
     "it did "
     "not fall.",
     "Er wird mit {} geworfen: sein Schwerpunkt fliegt auf einer Parabel{}, während der Körper sich um diesen "
     "Punkt "
     "dreht, als fiele er nicht."},

    // the picture
    {"red", "Rot"},
    {"orange-red", "Orangerot"},
    {"orange", "Orange"},
    {"yellow", "Gelb"},
    {"green", "Grün"},
    {"cyan", "Türkis"},
    {"blue", "Blau"},
    {"purple", "Violett"},
    {"black", "Schwarz"},
    {"white", "Weiß"},
    {"grey", "Grau"},
    {"In {}: {}.", "In {}: {}."},
    {"an arrow for L", "ein Pfeil für L"},
    {"the invariable plane at right angles to it", "die invariable Ebene im rechten Winkel dazu"},
    {"the plane through L and ω", "die Ebene durch L und ω"},
    {"the two parts of L, head to tail", "die zwei Teile von L, aneinandergesetzt"},
    {"the height 2T/L of the centre", "die Höhe 2T/L der Mitte"},
    {"the space cone, which ω traces around L", "der Rastpolkegel, den ω um L beschreibt"},
    {"the angular momentum about the origin, with R × P and L as its parts",
     "der Drehimpuls um den Ursprung mit seinen Teilen R × P und L"},
    {"the sphere on which the tip of L stays", "die Kugel, auf der die Spitze von L bleibt"},
    {"the area on the sphere that the polhode encloses", "die Fläche der Kugel, die die Polhodie umschließt"},
    {"an arrow for ω", "ein Pfeil für ω"},
    {"the polhode on the body", "die Polhodie im Körper"},
    {"the herpolhode in space", "die Herpolhodie im Raum"},
    {"polhodes of other starts, with the separatrix", "Polhodien anderer Anfänge, mit der Separatrix"},
    {"the energy ellipsoid", "das Energieellipsoid"},
    {"the parts of ω, as a parallelogram", "die Teile von ω als Parallelogramm"},
    {"the parts of ω along i and k", "die Teile von ω entlang i und k"},
    {"the components of ω along the principal axes", "die Komponenten von ω entlang der Hauptachsen"},
    {"the table on which it rolls", "der Tisch, auf dem er rollt"},
    {"the body", "der Körper"},
    {"paler poses of it at other times", "blassere Lagen von ihm zu anderen Zeiten"},
    {"its principal axes e1, e2 and e3", "seine Hauptachsen e1, e2 und e3"},
    {"some of its principal axes", "einige seiner Hauptachsen"},
    {"the main axis k", "die Hauptachse k"},
    {"the body cone about it", "der Gangpolkegel um sie"},
    {"the axes i, j and k, with i in the plane of L and k",
     "die Achsen i, j und k, mit i in der Ebene von L und k"},
    {"the path of a point of the body", "die Bahn eines Punktes des Körpers"},
    {"an arrow for the torque", "ein Pfeil für das Drehmoment"},
    {"an arrow r to it from the point that the body turns about",
     "ein Pfeil r dorthin von dem Punkt, um den der Körper sich dreht"},
    {"an arrow for each force at its point of the body, while it acts",
     "ein Pfeil für jede Kraft an ihrem Punkt des Körpers, solange sie wirkt"},
    {"the axes x, y and z of space", "die Achsen x, y und z des Raums"},
    {"the angle θ between k and the vertical", "der Winkel θ zwischen k und der Senkrechten"},
    {"the angle θ between L and k", "der Winkel θ zwischen L und k"},
    {"{} “{}”", "{} „{}“"},
    {"an arrow", "ein Pfeil"},
    {"an angle", "ein Winkel"},
    {"Also shown: {}.", "Außerdem zu sehen: {}."},
    {"as it looks to an observer at rest in space", "so, wie ein im Raum ruhender Beobachter sie sieht"},
    {"as it looks to an observer who rides on the body, which stands still while space turns about it",
     "so, wie ein Beobachter sie sieht, der auf dem Körper mitfährt, der stillsteht, während sich der Raum um ihn "
     "dreht"},
    {"as it looks to an observer who goes round L with the axis, so that L, ω and the axis stand still",
     "so, wie ein Beobachter sie sieht, der mit der Achse L umläuft, so dass L, ω und die Achse stillstehen"},
    {", with {}", ", mit: {}"},
    {"the path of its centre of mass", "die Bahn seines Schwerpunkts"},
    {"an arrow from the origin to the point by which it is thrown",
     "ein Pfeil vom Ursprung zu dem Punkt, an dem er geworfen wird"},
    {"an arrow for the velocity of this point", "ein Pfeil für die Geschwindigkeit dieses Punktes"},
    {"an arrow from the origin to where it is", "ein Pfeil vom Ursprung zu seinem Ort"},
    {"an arrow for its velocity", "ein Pfeil für seine Geschwindigkeit"},
    {"an arrow for its weight", "ein Pfeil für sein Gewicht"},
    {"The picture shows the motion {}.", "Das Bild zeigt die Bewegung {}."},
    {"The picture has {} panels, all at the same instant.", "Das Bild hat {} Felder, alle im selben Augenblick."},
    {"Panel {}{}: {}.", "Feld {}{}: die Bewegung {}."},
    {", “{}”", ", „{}“"},
    {", “{}”,", " „{}“"},
    {"the time of the film", "der Filmzeit"},
    {"time", "der Zeit"},
    {"A plot{} shows {} against {}, with a cursor at the instant of the picture.",
     "Ein Diagramm{} zeigt {} in Abhängigkeit von {}, mit einer Marke im Augenblick des Bildes."},
    {" is", " steht"},
    {" are", " stehen"},
    {"At the edge of the picture, {} written in numbers.", "Am Rand des Bildes: {} dort in Zahlen."},
    {"Written in the picture: “{}”.", "Im Bild steht: „{}“."},
    {"The angles between ω, L and the axis are drawn as if the part of ω across the axis were {} times larger.",
     "Die Winkel zwischen ω, L und der Achse sind gezeichnet, als wäre der Teil von ω quer zur Achse {}-mal so "
     "groß."},
    {"at the true pace", "in wahrer Geschwindigkeit"},
    {"{} times faster than in reality", "{}-mal schneller als in Wirklichkeit"},
    {"{} times slower than in reality", "{}-mal langsamer als in Wirklichkeit"},
    {"at {} of the true pace", "mit dem {}-fachen der wahren Geschwindigkeit"},
    {"The film lasts {}; the motion stands still.", "Der Film dauert {}; die Bewegung steht still."},
    {"The film lasts {} and shows {} of motion{}, {}{}.", "Der Film dauert {} und zeigt {} der Bewegung{}, {}{}."},
    {" backwards", " rückwärts"},
    {"at a pace that changes", "in wechselnder Geschwindigkeit"},
    {"; then it repeats without a jump", "; dann wiederholt er sich ohne Sprung"},

    // sweeps and maps
    {"{} from {} to {}", "{} von {} bis {}"},
    {"{} from left to right, {} from top to bottom", "{} von links nach rechts, {} von oben nach unten"},
    {"{} pictures of one scene side by side, at one instant: {}. The first: {}",
     "{} Bilder einer Szene nebeneinander, in einem Augenblick: {}. Das erste: {}"},
    {"{} pictures of one scene side by side, at several instants: {}. The first: {}",
     "{} Bilder einer Szene nebeneinander, in mehreren Augenblicken: {}. Das erste: {}"},
    {"A map of how long the body takes from flip to flip, for every direction of L in it: a sphere of directions, "
     "from {} in dark colours at the axes {} and {}, the stable ones, to {} and more in pale ones near {}, the "
     "unstable "
     "one. Two circles through the unstable axis, the separatrix, divide the two kinds of motion; on them the "
     "time is "
     "infinite. The scene's own L is marked; it flips every {}.",
     "Eine Karte der Zeit von einem Umkippen des Körpers zum nächsten, für jede Richtung von L in ihm: eine Kugel "
     "der "
     "Richtungen, von {} in dunklen Farben an den Achsen {} und {}, den stabilen, bis {} und mehr in hellen "
     "Farben nahe "
     "{}, der instabilen. Zwei Kreise durch die instabile Achse, die Separatrix, trennen die beiden Arten der "
     "Bewegung; auf ihnen ist die Zeit unendlich. Das L der Szene ist markiert; sie kippt alle {}."},
};

thread_local scene::Language current = scene::Language::kEnglish;

}  // namespace

LanguageScope::LanguageScope(scene::Language language) : before_(std::exchange(current, language)) {}
LanguageScope::~LanguageScope() { current = before_; }

std::span<const Translation> translations() { return kGerman; }

std::string_view translated(std::string_view english) {
  if (current == scene::Language::kEnglish) return english;
  static const auto german = [] {
    std::map<std::string_view, std::string_view> map;
    for (const Translation& each : kGerman) map.emplace(each.english, each.german);
    return map;
  }();
  const auto found = german.find(english);
  POINSOT_EXPECT(found != german.end());
  return found->second;
}

bool hasDecimalComma() { return current == scene::Language::kGerman; }

}  // namespace poinsot::describe
