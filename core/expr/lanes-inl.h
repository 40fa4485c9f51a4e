/// \file
/// A vector of doubles that reads like one double. To be included within a namespace for each set
/// of instructions (no guard), behind hwy/highway.h.

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, 8>;

struct Mask {
  hn::Mask<Tag> m;
};

struct Lanes {
  explicit Lanes(hn::Vec<Tag> vector) : v(vector) {}
  explicit Lanes(double x) : v(hn::Set(Tag(), x)) {}
  hn::Vec<Tag> v;
};

HWY_INLINE Lanes load(const double* from) {
  return Lanes(hn::LoadU(Tag(), from));
}
HWY_INLINE void store(Lanes x, double* to) {
  hn::StoreU(x.v, Tag(), to);
}

HWY_INLINE Lanes operator+(Lanes a, Lanes b) {
  return Lanes(hn::Add(a.v, b.v));
}
HWY_INLINE Lanes operator-(Lanes a, Lanes b) {
  return Lanes(hn::Sub(a.v, b.v));
}
HWY_INLINE Lanes operator*(Lanes a, Lanes b) {
  return Lanes(hn::Mul(a.v, b.v));
}
HWY_INLINE Lanes operator/(Lanes a, Lanes b) {
  return Lanes(hn::Div(a.v, b.v));
}
HWY_INLINE Lanes operator-(Lanes a) {
  return Lanes(hn::Neg(a.v));
}
HWY_INLINE Mask operator<(Lanes a, Lanes b) {
  return {hn::Lt(a.v, b.v)};
}
HWY_INLINE Mask operator>(Lanes a, Lanes b) {
  return {hn::Gt(a.v, b.v)};
}
HWY_INLINE Mask operator<=(Lanes a, Lanes b) {
  return {hn::Le(a.v, b.v)};
}
HWY_INLINE Mask operator>=(Lanes a, Lanes b) {
  return {hn::Ge(a.v, b.v)};
}
HWY_INLINE Mask operator==(Lanes a, Lanes b) {
  return {hn::Eq(a.v, b.v)};
}
// Highway's own Ne is ordered on x86: NaN would not differ from NaN.
HWY_INLINE Mask operator!=(Lanes a, Lanes b) {
  return {hn::Not(hn::Eq(a.v, b.v))};
}
HWY_INLINE Mask operator&(Mask a, Mask b) {
  return {hn::And(a.m, b.m)};
}
HWY_INLINE Mask operator|(Mask a, Mask b) {
  return {hn::Or(a.m, b.m)};
}

HWY_INLINE Mask both(Mask a, Mask b) {
  return a & b;
}
HWY_INLINE Mask either(Mask a, Mask b) {
  return a | b;
}

HWY_INLINE Lanes choose(Mask mask, Lanes yes, Lanes no) {
  return Lanes(hn::IfThenElse(mask.m, yes.v, no.v));
}
HWY_INLINE Lanes absolute_of(Lanes x) {
  return Lanes(hn::Abs(x.v));
}
HWY_INLINE Lanes root_of(Lanes x) {
  return Lanes(hn::Sqrt(x.v));
}
HWY_INLINE Lanes floor_of(Lanes x) {
  return Lanes(hn::Floor(x.v));
}
HWY_INLINE bool all(Mask mask) {
  return hn::AllTrue(Tag(), mask.m);
}

// One bit a lane, the first lane lowest.
HWY_INLINE std::uint32_t bits_of(Mask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Tag(), mask.m, bytes);
  return bytes[0];
}

// The definitions of kMin and kMax: NaN wins, of equals the first.
HWY_INLINE Lanes lesser_of(Lanes a, Lanes b) {
  return choose((b < a) | (b != b), b, a);
}
HWY_INLINE Lanes greater_of(Lanes a, Lanes b) {
  return choose((b > a) | (b != b), b, a);
}

#include "core/expr/sine_kernel-inl.h"

// What plain reduction is not good enough for is left to the scalar function, lane by lane.
HWY_INLINE Lanes with_hard_lanes(Lanes x, Lanes value, Mask plain, double (*f)(double)) {
  if (all(plain)) return value;
  const std::uint32_t done = bits_of(plain);
  alignas(64) double values[hn::MaxLanes(Tag())];
  alignas(64) double arguments[hn::MaxLanes(Tag())];
  store(value, values);
  store(x, arguments);
  for (std::size_t i = 0; i < hn::Lanes(Tag()); ++i) {
    if ((done >> i & 1) == 0) values[i] = f(arguments[i]);
  }
  return load(values);
}

HWY_INLINE Lanes sine_of(Lanes x) {
  const QuarterTurns<Lanes> r = reduce_plainly(x);
  const Lanes value = choose(absolute_of(x) < Lanes(kTiny), x, sine_of(r, 0));
  return with_hard_lanes(x, value, plainly_reducible(x, r), sine);
}

HWY_INLINE Lanes cosine_of(Lanes x) {
  const QuarterTurns<Lanes> r = reduce_plainly(x);
  const Lanes value = choose(absolute_of(x) < Lanes(kTiny), Lanes(1.0), sine_of(r, 1));
  return with_hard_lanes(x, value, plainly_reducible(x, r), cosine);
}
