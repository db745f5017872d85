// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>
#include <utility>

#include "gl/gl_includes.h"

namespace poinsot::gl {

/// Scope in which owners of OpenGL names on this thread do not delete them. The context frees the names at its
/// end. Used if owners are destroyed while another context is current, which may use the same names.
class AbandonedNames {
 public:
  explicit AbandonedNames(bool abandoned) { abandoned_ = abandoned; }
  ~AbandonedNames() { abandoned_ = false; }
  AbandonedNames(const AbandonedNames&) = delete;
  AbandonedNames& operator=(const AbandonedNames&) = delete;

  static bool now() { return abandoned_; }

 private:
  static inline thread_local bool abandoned_ = false;
};

/// Owner of one OpenGL name, such as a texture's, which it deletes. Can be moved but not copied; 0 means no name.
/// When the owner is destroyed, the name's context must be current, or an AbandonedNames must exist.
template <typename Traits>
class UniqueName {
 public:
  UniqueName() = default;
  static UniqueName make() {
    UniqueName name;
    name.id_ = Traits::create();
    return name;
  }
  ~UniqueName() {
    if (id_ && !AbandonedNames::now()) Traits::destroy(id_);
  }
  UniqueName(UniqueName&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  UniqueName& operator=(UniqueName&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  UniqueName(const UniqueName&) = delete;
  UniqueName& operator=(const UniqueName&) = delete;

  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  GLuint id_ = 0;
};

struct BufferTraits {
  static GLuint create() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};
struct VertexArrayTraits {
  static GLuint create() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};
struct TextureTraits {
  static GLuint create() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
struct FramebufferTraits {
  static GLuint create() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};
struct ProgramTraits {
  static GLuint create() { return glCreateProgram(); }
  static void destroy(GLuint id) { glDeleteProgram(id); }
};

using BufferName = UniqueName<BufferTraits>;
using VertexArrayName = UniqueName<VertexArrayTraits>;
using TextureName = UniqueName<TextureTraits>;
using FramebufferName = UniqueName<FramebufferTraits>;
using ProgramName = UniqueName<ProgramTraits>;

static_assert(std::is_nothrow_move_constructible_v<BufferName> && !std::is_copy_constructible_v<BufferName>);

}  // namespace poinsot::gl
