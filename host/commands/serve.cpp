// `slipstick serve`: the daemon.
#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <sstream>
#include <utility>

#include "host/atomic_file.h"
#include "host/commands/command.h"
#include "host/interrupt.h"
#include "host/serve/daemon.h"
#include "host/serve/hook_runner.h"

namespace slipstick {
namespace {

// Where services keep their state, or a user his data.
std::string default_data_folder() {
  if (const char* state = std::getenv("STATE_DIRECTORY")) return state;  // of systemd
  if (const char* data = std::getenv("XDG_DATA_HOME")) return std::string(data) + "/slipstick";
  const char* home = std::getenv("HOME");
  return home == nullptr ? "/var/lib/slipstick" : std::string(home) + "/.local/share/slipstick";
}

// Who is told what, from the command line.
struct ServeWords {
  std::string broker;
  std::string password_file;
  std::string name;
  bool commands = false;
  std::string config;
  std::vector<std::string> hooks;
  std::string power_on;
};

Result<std::optional<MqttBridge::Options>> mqtt_options(const ServeWords& words) {
  if (words.broker.empty()) return std::optional<MqttBridge::Options>();
  auto address = parse_mqtt_address(words.broker);
  if (!address) return fail(address.error());
  auto name = parse_mqtt_name(words.name.empty() ? default_mqtt_name() : words.name);
  if (!name) return fail(name.error());
  std::string password;
  if (!words.password_file.empty()) {
    auto text = read_file(words.password_file);
    if (!text) return fail(text.error());
    password = text->substr(0, text->find_first_of("\r\n"));
  }
  return std::optional<MqttBridge::Options>(
      {*std::move(address), std::move(password), *std::move(name),
       words.commands ? MqttCommands::kObeyed : MqttCommands::kIgnored});
}

Result<std::vector<Hook>> hooks_of(const std::vector<std::string>& words) {
  std::vector<Hook> hooks;
  for (const std::string& word : words) {
    auto hook = parse_hook(word);
    if (!hook) return fail(hook.error());
    hooks.push_back(*std::move(hook));
  }
  if (hooks.size() <= HookRunner::kHooksMax) return hooks;
  return fail(ErrorCode::kInput, fmt::format("--hook: more than {}", HookRunner::kHooksMax));
}

// Options of `serve` that were not given as words. What is wrong there is wrong usage.
void read_config(CLI::App& serve, const std::string& path) {
  const auto text = read_file(path);
  if (!text) throw CLI::ValidationError("--config", text.error().message);
  std::istringstream lines(*text);
  try {
    serve.parse_from_stream(lines);
  } catch (const CLI::ParseError& error) {
    throw CLI::ValidationError("--config " + path, error.what());
  }
}

CommandResult run_serve(Daemon::Options options, const ServeWords& words) {
  auto hooks = hooks_of(words.hooks);
  if (!hooks) return fail(hooks.error());
  options.hooks = *std::move(hooks);
  if (!words.power_on.empty()) {
    auto target = HookTarget::from(words.power_on);
    if (!target) return fail(target.error().within("--power-on"));
    options.power_on = *std::move(target);
  }
  auto bridge = mqtt_options(words);
  if (!bridge) return fail(bridge.error());
  options.mqtt = *std::move(bridge);
  const auto daemon = Daemon::start(options);
  if (!daemon) return fail(daemon.error());
  fmt::print("listening on {}\n", (*daemon)->url());
  if (!(*daemon)->key().empty()) {
    fmt::print("programs need a key: the one in {}, or one made on the page\n",
               (options.data / "api_key").string());
  }
  if (const std::string code = (*daemon)->setup_code(); !code.empty()) {
    fmt::print(
        "there is no account yet; open the page and make one with the code {} (also in {})\n", code,
        (options.data / "setup_code").string());
  }
  std::fflush(stdout);
  (*daemon)->run([] { return !Interrupt::requested(); });
  return 0;
}

}  // namespace

void add_serve_command(CLI::App& app, ChosenCommand& run) {
  const auto options = std::make_shared<Daemon::Options>();
  const auto words = std::make_shared<ServeWords>();
  options->data = default_data_folder();
  options->port = "sim:?realtime=1";
  CLI::App* sub = app.add_subcommand("serve", "the daemon: job queue, HTTP API, web page");
  sub->allow_config_extras(CLI::config_extras_mode::error);
  sub->add_option("--config", words->config, "TOML file with any of these options: hook = [\"…\"]")
      ->configurable(false);
  sub->add_option("--data", options->data, "folder for jobs and files")->capture_default_str();
  sub->add_option("--listen", options->listen,
                  "HOST:PORT; off this machine an account or a key is needed")
      ->capture_default_str();
  sub->add_option("--printer", options->port,
                  "/dev/ttyUSB0, usb:VID:PID[:SERIAL], pty:PATH, tcp:HOST:PORT or sim:")
      ->capture_default_str();
  sub->add_option("--machine", options->defaults.printer,
                  "settings of jobs that do not say otherwise: name from configs/printers")
      ->capture_default_str();
  sub->add_option("--material", options->defaults.material, "likewise, from configs/materials")
      ->capture_default_str();
  sub->add_option("--profile", options->defaults.profile, "likewise, from configs/profiles");
  sub->add_option("--mqtt", words->broker, "broker that is told: mqtt[s]://[USER@]HOST[:PORT]");
  sub->add_option("--mqtt-password-file", words->password_file, "its first line is the password");
  sub->add_option("--mqtt-name", words->name,
                  "of this printer in topics; else that of the machine");
  sub->add_flag("--mqtt-commands", words->commands, "obey slipstick/NAME/command, too");
  sub->add_option("--hook", words->hooks,
                  "EVENT=URL or EVENT=/PROGRAM, told of it, repeatable: " + occasion_names());
  sub->add_option("--power-on", words->power_on,
                  "URL or /PROGRAM that switches the printer on; a print waits for it");
  sub->add_option(
      "--camera", options->camera,
      "address of the printer's picture (MJPEG or JPEG), shown on the page: http://...");
  sub->footer("Example: slipstick serve --printer /dev/ttyUSB0 --machine ender3");
  sub->callback([options, words, sub, &run] {
    // Once the words are known, which win; then this is called again.
    if (!words->config.empty()) return read_config(*sub, std::exchange(words->config, {}));
    run = [options, words] { return run_serve(*options, *words); };
  });
}

}  // namespace slipstick
