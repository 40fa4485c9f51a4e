#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace slipstick {

/// What a command returns: the exit status, or why the job failed (status 1, or 130 if
/// interrupted).
using CommandResult = Result<int>;

/// Each adds one subcommand to `app`; `run` is set to what is to be done if the user chose it.
using ChosenCommand = std::function<CommandResult()>;

void add_slice_command(CLI::App& app, ChosenCommand& run);
/// \param words the whole command line but the program's name, for the journal.
void add_print_command(CLI::App& app, ChosenCommand& run, const std::vector<std::string>& words);
void add_sim_command(CLI::App& app, ChosenCommand& run);
void add_verify_command(CLI::App& app, ChosenCommand& run);
void add_convert_command(CLI::App& app, ChosenCommand& run);
void add_info_command(CLI::App& app, ChosenCommand& run);
void add_ports_command(CLI::App& app, ChosenCommand& run);
void add_bench_command(CLI::App& app, ChosenCommand& run);
void add_serve_command(CLI::App& app, ChosenCommand& run);
void add_figure_command(CLI::App& app, ChosenCommand& run);

}  // namespace slipstick
