#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "drivers/unique_fd.h"

namespace slipstick {

/// A Unix socket that takes lines and answers each with one. One client at a time; a newer one
/// replaces an older one. Never waits.
class ControlSocket {
 public:
  static constexpr std::size_t kLineMax = 512;
  using Obey = std::function<std::string(std::string_view line)>;

  /// Listens at `path`; what an earlier run left there is removed.
  /// \return kUnavailable if something else is there, or somebody listens already.
  [[nodiscard]] static Result<ControlSocket> open(const std::string& path);

  ControlSocket(ControlSocket&&) noexcept = default;
  ControlSocket& operator=(ControlSocket&&) = delete;
  ~ControlSocket();

  /// What to poll for input; the second one is -1 without a client.
  [[nodiscard]] int listener() const { return listener_.get(); }
  [[nodiscard]] int client() const { return client_.get(); }

  /// Takes a client that has come.
  void accept();
  /// Reads what is there, answers every whole line by what `obey` says. A longer line than
  /// `kLineMax` ends the connection.
  void serve(const Obey& obey);

 private:
  ControlSocket(UniqueFd listener, std::string path)
      : listener_(std::move(listener)), path_(std::move(path)) {}

  UniqueFd listener_;
  UniqueFd client_;
  std::string path_;  ///< Removed at the end.
  std::string heard_;
};

}  // namespace slipstick
