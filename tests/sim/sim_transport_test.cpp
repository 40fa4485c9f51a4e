#include "sim/sim_transport.h"

#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <thread>

using namespace slipstick;

namespace {

constexpr std::chrono::seconds kPatience{1};

/// Reads until `end` was seen or nothing comes for a second.
std::string read_until(SimTransport& transport, std::string_view end) {
  std::string text;
  std::array<char, 64> buffer{};
  while (text.find(end) == std::string::npos) {
    const auto count = transport.read_some(buffer, kPatience);
    if (!count) break;
    text.append(buffer.data(), *count);
  }
  return text;
}

}  // namespace

TEST_CASE("The options of an address are read") {
  const auto options = sim_options({{"seed", "7"},
                                    {"corrupt", "0.002"},
                                    {"baud", "250000"},
                                    {"realtime", "1"},
                                    {"firmware", "marlin-2.1.2"},
                                    {"kinematics", "delta"},
                                    {"jerk", "classic"},
                                    {"latency", "16"},
                                    {"with", "linear-advance"}});

  REQUIRE(options);
  const MachineOptions& machine = options->printer.machine;
  CHECK(machine.kinematics.homes_all());
  CHECK(machine.limits.speed_max.z == machine.limits.speed_max.x);
  CHECK(machine.limits.jerk->z == 10);
  CHECK(machine.features.has(Feature::kLinearAdvance));
  CHECK(options->printer.seed == 7);
  CHECK(options->printer.corrupt == 0.002);
  CHECK(options->printer.baud == 250000);
  CHECK(options->realtime);
  CHECK(options->printer.latency == Moment(16'000));
}

TEST_CASE("An unknown option or value is refused with what there is") {
  for (const auto& [name, value] : std::map<std::string, std::string>{{"speed", "1"},
                                                                      {"baud", "fast"},
                                                                      {"baud ", "1"},
                                                                      {"corrupt", "2"},
                                                                      {"seed", "-1"},
                                                                      {"realtime", "yes"},
                                                                      {"firmware", "marlin"},
                                                                      {"kinematics", "scara"},
                                                                      {"jerk", "10"},
                                                                      {"latency", "300"},
                                                                      {"fault", "bad-luck"},
                                                                      {"with", "wings"}}) {
    const auto options = sim_options({{name, value}});
    INFO(name << "=" << value);
    REQUIRE_FALSE(options);
    CHECK(options.error().code == ErrorCode::kInput);
    CHECK(options.error().message.find(name) != std::string::npos);
  }
}

TEST_CASE("Waiting for a byte makes time pass until it comes") {
  SimTransport transport({});

  const std::string banner = read_until(transport, "D114.00\n");

  CHECK(banner.starts_with("start\n"));
  CHECK(transport.clock().now() == Firmware::kBootTime);
}

TEST_CASE("Patience is virtual too") {
  SimTransport transport({});
  read_until(transport, "D114.00\n");
  std::array<char, 8> buffer{};

  const auto count = transport.read_some(buffer, std::chrono::hours(1));

  REQUIRE_FALSE(count);
  CHECK(count.error().code == ErrorCode::kTimedOut);
  CHECK(transport.clock().now() == Firmware::kBootTime + std::chrono::hours(1));
}

TEST_CASE("A line over a paced wire takes its ten bits a byte") {
  SimTransport transport({.printer = {.baud = 115200}});
  read_until(transport, "D114.00\n");
  const Moment before = transport.clock().now();

  REQUIRE(transport.write_all("M117 abcd\n", kPatience));
  CHECK(read_until(transport, "ok\n") == "ok\n");

  // 10 bytes there and 3 back at 86.8 µs each.
  CHECK((transport.clock().now() - before).count() == Approx(13 * 86.8).margin(3));
}

TEST_CASE("A printer that does not read fills the port's buffer and then lets a write time out") {
  SimTransport transport({});
  read_until(transport, "D114.00\n");
  REQUIRE(transport.write_all("M112\n", kPatience));
  read_until(transport, "called!\n");

  const auto written = transport.write_all(std::string(10'000, 'x'), kPatience);

  REQUIRE_FALSE(written);
  CHECK(written.error().code == ErrorCode::kTimedOut);
}

TEST_CASE("After shutting down nothing goes in or out") {
  SimTransport transport({});
  transport.shut_down();
  std::array<char, 8> buffer{};

  CHECK(transport.read_some(buffer, kPatience).error().code == ErrorCode::kCancelled);
  CHECK(transport.write_all("x", kPatience).error().code == ErrorCode::kCancelled);
}

TEST_CASE("Shutting down wakes a reader in real time") {
  SimTransport transport({.printer = {}, .realtime = true});
  std::thread reader([&] {
    std::array<char, 4096> buffer{};
    while (true) {
      const auto count = transport.read_some(buffer, std::chrono::hours(1));
      if (count) continue;
      CHECK(count.error().code == ErrorCode::kCancelled);
      return;
    }
  });

  transport.shut_down();

  reader.join();
}

TEST_CASE("Running down ends at a printer that was killed, whatever it still has to say") {
  SimTransport transport({});
  read_until(transport, "D114.00\n");
  REQUIRE(transport.write_all("G1 X100 F600\n", kPatience));
  read_until(transport, "ok\n");
  REQUIRE(transport.write_all("M112\n", kPatience));
  const Moment before = transport.printer().now();

  transport.run_down(std::chrono::minutes(1));

  CHECK(transport.printer().machine().halted);
  CHECK(transport.printer().now() < before + std::chrono::seconds(10));
}

TEST_CASE("Running down passes over what nobody reads") {
  SimTransport transport({});
  read_until(transport, "D114.00\n");
  REQUIRE(transport.write_all("G1 X100 F600\n", kPatience));
  read_until(transport, "ok\n");
  REQUIRE(transport.write_all("M115\n", kPatience));

  transport.run_down(std::chrono::minutes(1));

  CHECK(transport.printer().machine().planner.idle());
}

TEST_CASE("Running down lets the machine finish its moves") {
  SimTransport transport({});
  read_until(transport, "D114.00\n");
  REQUIRE(transport.write_all("G1 X100 F600\n", kPatience));
  read_until(transport, "ok\n");

  transport.run_down(std::chrono::minutes(1));

  // 100 mm at 10 mm/s, the ramps' 1/300 s and the first move's 100 ms.
  CHECK(transport.printer().machine().planner.idle());
  CHECK(transport.printer().statistics().motion.last_move_seconds ==
        Approx(0.07 + 0.1 + 10 + 1 / 300.0).epsilon(1e-5));
}
