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

TEST_CASE("threads: an image that is forgotten while it is made still comes to who made it") {
  std::promise<void> begun, forgotten;
  ImageWindow window(kGrid, 0, 10, [&](int) {
    begun.set_value();
    forgotten.get_future().wait();
    return some_image();
  });
  std::atomic<bool> came = false;
  std::jthread maker([&] { came = window.image(3).has_value(); });
  begun.get_future().wait();

  window.forget_below(9);
  forgotten.set_value();
  maker.join();

  CHECK(came);
}
