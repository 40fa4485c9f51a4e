#include "host/turnaround.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"

using namespace slipstick;

TEST_CASE("Nothing answered is within no time") {
  Turnaround none;
  none.answered(Moment(5));  // nothing was heard

  CHECK(none.count() == 0);
  CHECK(none.within(0.99) == Moment(0));
}

TEST_CASE("A share of the turnarounds is within a time at most a sixteenth too long") {
  Turnaround turnaround;
  Rng rng(1);
  std::vector<std::int64_t> took;
  for (int i = 0; i < 5000; ++i) {
    took.push_back(static_cast<std::int64_t>(rng.below(std::uint64_t{1} << rng.below(25))));
    turnaround.heard(Moment(1000));
    turnaround.answered(Moment(1000 + took.back()));
  }
  std::sort(took.begin(), took.end());

  CHECK(turnaround.count() == took.size());
  for (const double share : {0.001, 0.5, 0.9, 0.99, 1.0}) {
    INFO(share);
    const auto exact = took[static_cast<std::size_t>(std::ceil(share * 5000)) - 1];
    CHECK(turnaround.within(share).count() >= exact);
    CHECK(turnaround.within(share).count() <= exact + exact / 16);
  }
}

TEST_CASE("A turn that ends without an answer counts nothing, and a minute is the most") {
  Turnaround turnaround;
  turnaround.heard(Moment(1));
  turnaround.forget();
  turnaround.answered(Moment(2));
  CHECK(turnaround.count() == 0);

  turnaround.heard(Moment(0));
  turnaround.answered(std::chrono::hours(5));

  CHECK(turnaround.within(1) >= std::chrono::minutes(1));
  CHECK(turnaround.within(1) <= std::chrono::seconds(64));
}
