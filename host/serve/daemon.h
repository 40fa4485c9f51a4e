#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/serve/hook.h"
#include "host/serve/http_server.h"
#include "host/serve/job_spec.h"
#include "host/serve/mqtt_bridge.h"

namespace slipstick {

/// The daemon: a printer, its queue, and the HTTP server through which both are reached.
class Daemon {
 public:
  struct Options {
    std::filesystem::path data;
    std::string listen = "127.0.0.1:5000";
    std::string port;  ///< Of the printer.
    JobDefaults defaults;
    HttpLimits http;
    std::optional<MqttBridge::Options> mqtt;  ///< Nobody is told without it.
    std::optional<HookTarget> power_on;
    std::vector<Hook> hooks;  ///< At most `HookRunner::kHooksMax`.
    std::string camera = {};  ///< As CameraUrl, or empty: there is none.
  };

  /// Opens everything; from then on requests are let wait. Only one daemon a data folder.
  /// \return kInput for an address that is none; kUnavailable if something cannot be had.
  [[nodiscard]] static Result<std::unique_ptr<Daemon>> start(const Options& options);
  /// Ends a print under way with the heaters off.
  ~Daemon();

  /// "http://127.0.0.1:5000".
  [[nodiscard]] std::string url() const;
  /// An administrator's key, for `X-Api-Key`; empty on the loopback address.
  [[nodiscard]] const std::string& key() const;
  /// What the first account is made with; empty if there is one, or none is needed.
  [[nodiscard]] std::string setup_code() const;

  /// Answers requests until `goes_on`, asked ten times a second, says no.
  void run(const std::function<bool()>& goes_on);

 private:
  class Implementation;
  explicit Daemon(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace slipstick
