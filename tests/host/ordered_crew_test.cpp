#include "host/ordered_crew.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <memory>

using namespace slipstick;

using Crew = OrderedCrew<int>;

TEST_CASE("threads: items come in order, each once, whatever the workers do") {
  for (const int workers : {1, 2, 4}) {
    Crew crew({3, 200, workers, workers + 2}, [](int item) -> Result<int> { return item * 10; });

    for (int i = 3; i < 200; ++i) {
      const auto item = crew.next();
      REQUIRE(item);
      REQUIRE(*item == i * 10);
    }
    CHECK(*crew.next() == std::nullopt);
    CHECK(crew.ready());
  }
}

TEST_CASE("threads: nothing is begun beyond the window") {
  std::atomic<int> furthest = 0;
  std::atomic<int> due = 0;
  std::atomic<bool> kept = true;
  constexpr int kWindow = 3;
  Crew crew({0, 500, 4, kWindow}, [&](int item) -> Result<int> {
    if (item > due + kWindow) kept = false;
    furthest = std::max(furthest.load(), item);
    return item;
  });

  for (int i = 0; i < 500; ++i) {
    REQUIRE(crew.next());
    due = i + 1;
  }

  CHECK(kept);
  CHECK(furthest == 499);
}

TEST_CASE("threads: an error comes in its turn and is the last") {
  Crew crew({0, 100, 2, 4}, [](int item) -> Result<int> {
    if (item == 5) return fail(ErrorCode::kInput, "five");
    return item;
  });

  for (int i = 0; i < 5; ++i) REQUIRE(*crew.next() == i);
  const auto failed = crew.next();

  REQUIRE_FALSE(failed);
  CHECK(failed.error().message == "five");
  CHECK(*crew.next() == std::nullopt);
}

TEST_CASE("threads: a crew that nobody waits for goes away") {
  auto crew = std::make_unique<Crew>(Crew::Options{0, 1'000'000, 2, 4},
                                     [](int item) -> Result<int> { return item; });
  REQUIRE(crew->next());

  crew.reset();

  SUCCEED("joined");
}
