// `slipstick convert MODEL -o OUT`: between representations of solids, and Boolean operations.
#include <fmt/format.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "host/atomic_file.h"
#include "host/commands/command.h"
#include "host/conversion.h"
#include "host/options.h"

namespace slipstick {
namespace {

struct ConvertCommand {
  ConversionRequest request;
  std::vector<double> bounds;  ///< Six numbers, or none: the extent of a .vm.
  bool json = false;
};

CommandResult run_convert(const ConvertCommand& command) {
  ConversionRequest request = command.request;
  if (const auto ok = apply_bounds(command.bounds, request.loading); !ok) return fail(ok.error());
  const auto converted = convert(request);
  if (!converted) return fail(converted.error());
  if (const auto ok = write_file(request.output, converted->bytes); !ok) {
    return fail(ok.error());
  }
  for (const std::string& warning : converted->warnings)
    fmt::print(stderr, "warning: {}\n", warning);
  if (command.json) {
    const nlohmann::ordered_json json{{"output", request.output.string()},
                                      {"kind", converted->kind},
                                      {"size_of_representation", converted->size_text},
                                      {"bytes", converted->bytes.size()},
                                      {"warnings", converted->warnings}};
    std::cout << json.dump(2) << '\n';
    return 0;
  }
  fmt::print("{}: {}, {}, {} bytes\n", request.output.string(), converted->kind,
             converted->size_text, converted->bytes.size());
  return 0;
}

}  // namespace

void add_convert_command(CLI::App& app, ChosenCommand& run) {
  const auto command = std::make_shared<ConvertCommand>();
  ConversionRequest& request = command->request;
  CLI::App* sub = app.add_subcommand("convert", "a solid in another representation");
  sub->add_option("model", request.model, "the model")->required();
  sub->add_option("-o,--output", request.output, "FILE.ldni, .bsp or .rbf")->required();
  CLI::Option* with = sub->add_option("--with", request.with, "a second model, to join it with");
  sub->add_option("--boolean", request.operation, "union, intersection or difference (of --with)")
      ->needs(with)
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Boolean>{{"union", Boolean::kUnion},
                                         {"intersection", Boolean::kIntersection},
                                         {"difference", Boolean::kDifference}}));
  add_mesh_options(*sub, request.loading);
  add_bounds_option(*sub, command->bounds);
  sub->add_flag("--json", command->json, "print as JSON");
  sub->footer("Example: slipstick convert bunny.ply -o bunny.ldni --resolution 1500");
  sub->callback([command, &run] { run = [command] { return run_convert(*command); }; });
}

}  // namespace slipstick
