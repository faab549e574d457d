// Floor 5. Who is at work on a world, so that nobody changes it from within.
#pragma once

namespace cairn {

/// What a world is in the middle of, if anything. While a function that was given to it runs, as that of
/// World::edit, or an observer of World::step, a change of the same world would be lost or would pull away
/// what is being read. A copy is in the middle of nothing.
class Occupation {
 public:
  /// For as long as it lives.
  class Scope {
   public:
    /// `name` as in "World::edit".
    Scope(Occupation& occupation, const char* name) noexcept : occupation_(occupation) {
      occupation_.within_ = name;
    }
    /// Over.
    ~Scope() { occupation_.within_ = nullptr; }
    /// @cond
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    /// @endcond

   private:
    Occupation& occupation_;
  };

  /// In the middle of nothing.
  Occupation() = default;
  /// Free, whatever the other is in the middle of.
  Occupation(const Occupation&) noexcept {}
  /// Stays free. @throws std::logic_error in the middle of something.
  Occupation& operator=(const Occupation&) {
    refuse("World::operator=");
    return *this;
  }

  /// @throws std::logic_error that names `who`, a change, in the middle of something.
  void refuse(const char* who) const;

 private:
  const char* within_ = nullptr;
};

}  // namespace cairn
