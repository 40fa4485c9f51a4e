#include "host/image_window.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <future>
#include <thread>

using namespace slipstick;

namespace {

const SliceGrid kGrid = *SliceGrid::over({{0, 0}, {1, 1}}, 0.5);

Result<ImageWindow::Image> some_image() {
  return std::make_shared<const BitImage>(kGrid);
}

}  // namespace

TEST_CASE("An image is made once, and again only if it was forgotten") {
  std::atomic<int> made = 0;
  ImageWindow window(kGrid, 0, 10, [&](int) {
    ++made;
    return some_image();
  });
  REQUIRE(window.image(3));
  REQUIRE(window.image(3));
  CHECK(made == 1);

  window.forget_below(4);

  REQUIRE(window.image(3));
  CHECK(made == 2);
}

TEST_CASE("threads: an image that is forgotten while it is made still comes to all who wait") {
  std::promise<void> begun, forgotten;
  std::atomic<int> made = 0;
  ImageWindow window(kGrid, 0, 10, [&](int) {
    if (made++ == 0) {
      begun.set_value();
      forgotten.get_future().wait();
    }
    return some_image();
  });
  std::atomic<int> came = 0;
  const auto take = [&] { came += window.image(3).has_value() ? 1 : 0; };
  {
    const std::jthread maker(take);
    begun.get_future().wait();
    const std::jthread waiter(take);

    window.forget_below(9);
    forgotten.set_value();
  }

  CHECK(came == 2);
}
