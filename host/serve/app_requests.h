#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/serve/credentials.h"

namespace slipstick {

/// Programs that ask for a key without showing anything, and wait until somebody who is logged in
/// gives them one: OctoPrint's application keys. Nothing of it outlives the process.
///
/// Threads: one. Time is given by the caller.
class AppRequests {
 public:
  using Moment = std::chrono::steady_clock::time_point;
  static constexpr std::size_t kWaitingMost = 10;
  /// Who does not ask for its answer for so long has gone.
  static constexpr std::chrono::seconds kSilenceMost{15};
  /// Nobody decides about what was asked so long ago.
  static constexpr std::chrono::minutes kAgeMost{10};

  struct Waiting {
    std::int64_t id = 0;
    std::string app;
    std::string from;  ///< Address.
  };

  /// \return what its answer is asked for with; nothing if too many wait.
  [[nodiscard]] std::optional<std::string> ask(const AccountName& app, const std::string& from,
                                               Moment now);
  /// In the order in which they came.
  [[nodiscard]] std::vector<Waiting> waiting(Moment now);

  /// \return an empty text while it waits; the key, once; nothing if it was refused or is not
  /// known.
  [[nodiscard]] std::optional<std::string> answer(std::string_view token, Moment now);

  /// \return its name, if it still waits.
  [[nodiscard]] std::optional<std::string> name_of(std::int64_t id, Moment now);
  /// \pre it waits.
  void give(std::int64_t id, std::string key);
  /// \return whether it was there.
  bool refuse(std::int64_t id);

 private:
  struct Request {
    std::string token_hash;
    Waiting who;
    Moment asked;
    Moment heard;
    std::string key = {};  ///< Empty: not decided.
  };
  void forget_old(Moment now);

  std::map<std::int64_t, Request> requests_;
  std::int64_t last_ = 0;
};

}  // namespace slipstick
