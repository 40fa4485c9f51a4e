#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/affine.h"
#include "core/base/box.h"
#include "core/base/vec.h"
#include "core/solid/field.h"

namespace slipstick {

/// \file
/// Implicit solids (paper, section 1, definition 1): the points with f(p) <= 0.

class BitImage;

/// What is known of a rectangle of a section without looking at its points.
enum class Cover : std::uint8_t { kMixed, kInside, kOutside };

/// A solid cut by one plane z = constant of the print's frame.
///
/// Purity: whether a point is inside depends on the solid, the height and the point alone, never on
/// which points were asked together or through which narrowed section. Everything exact rests on
/// it.
///
/// Threads: a section is used by one thread at a time; it may hold scratch memory.
class Section {
 public:
  Section() = default;
  Section(const Section&) = delete;
  Section& operator=(const Section&) = delete;
  virtual ~Section() = default;

  /// Sets `inside[i]` to 1 where f(xs[i], ys[i]) <= 0, else to 0. NaN is outside.
  /// \pre The three spans have one length.
  virtual void classify(std::span<const double> xs, std::span<const double> ys,
                        std::span<std::uint8_t> inside) = 0;

  struct Narrowed;
  /// What is known of `box` as a whole, and, where that is not enough, a section that gives the
  /// same answers in the box for less work. `kInside` and `kOutside` are certain for every point of
  /// it.
  [[nodiscard]] virtual Narrowed narrowed(const Box2& box) = 0;

  /// f itself at the points, for solids that have values and not only an inside; \return false, and
  /// `values` untouched, where there are none. `classify` is 1 exactly where the value is <= 0.
  /// \pre The three spans have one length.
  virtual bool evaluate(std::span<const double> /*xs*/, std::span<const double> /*ys*/,
                        std::span<double> /*values*/) {
    return false;
  }

  /// Where membership may change on the way from one point to another along x or y, as shares of
  /// the way, in any order; for solids without values that know better than halving. A guess: it
  /// may be empty, rounded or of no use, and callers ask `classify` on both sides.
  virtual void guess_changes(Vec2 /*from*/, Vec2 /*to*/, std::vector<double>& shares) {
    shares.clear();
  }

  /// Sets the bits of all nodes within the ring of `image`, which is empty, for solids that know
  /// better than asking tile by tile; \return false, and `image` untouched, where they do not.
  /// The bits are those `classify` gives.
  virtual bool paint(BitImage& /*image*/) { return false; }

  /// A point at which f was NaN, if `classify` or `paint` met one, of this section or of one
  /// narrowed from it.
  [[nodiscard]] virtual std::optional<Vec2> undefined_at() const { return {}; }
};

struct Section::Narrowed {
  Cover cover = Cover::kMixed;
  /// Null: go on with the section that was asked.
  std::unique_ptr<Section> section;
};

/// A solid in the print's frame: millimetres, z upwards, its lowest point at z = 0.
/// Threads: all calls may be made from any thread at any time.
class Solid {
 public:
  Solid() = default;
  Solid(const Solid&) = delete;
  Solid& operator=(const Solid&) = delete;
  virtual ~Solid() = default;

  /// A finite box that holds all of the solid.
  [[nodiscard]] virtual Box3 bounds() const = 0;

  [[nodiscard]] virtual std::unique_ptr<Section> section(double z) const = 0;

  /// f and its gradient over boxes; null for solids that have none.
  [[nodiscard]] virtual std::unique_ptr<Field> field() const { return nullptr; }
};

/// A solid as it was loaded, in its own frame and units, to be placed on the bed.
/// Threads: as for `Solid`.
class Model {
 public:
  Model() = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
  virtual ~Model() = default;

  /// The box of the model under `map`, tight to about a thousandth of its size and never too small
  /// by more than that. Empty if the solid is.
  [[nodiscard]] virtual Box3 bounds_under(const Affine3& map) const = 0;

  /// The solid {map(p) : p in the model}. \pre `map` is invertible.
  [[nodiscard]] virtual std::shared_ptr<const Solid> placed(const Affine3& map) const = 0;

  /// "expression", "mesh", …
  [[nodiscard]] virtual std::string_view kind() const = 0;

  /// The size of the representation in words: "812 operations", "75408 triangles".
  [[nodiscard]] virtual std::string size_text() const = 0;
};

}  // namespace slipstick
