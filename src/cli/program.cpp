// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/program.hpp"

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <memory>
#include <new>
#include <vector>

#include "cli/command.hpp"
#include "cli/help_format.hpp"
#include "cli/streams.hpp"
#include "straightedge/host/kernels.hpp"

namespace straightedge::cli {
namespace {

int fail(const Failure& failure) {
  print_words("straightedge: " + one_line(failure.sentence));
  return static_cast<int>(failure.problem);
}

/// `first`: the first argument, empty when there is none.
int fail_usage(const CLI::App& program, const CLI::ParseError& error, const std::string& first) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const bool unknown_word = chosen.empty() && !first.empty() && first[0] != '-';
  const std::string sentence = unknown_word ? "\"" + first + "\" is no sub-command" : error.what();
  const std::string command = chosen.empty() ? "" : chosen.front()->get_name() + " ";
  return fail({Problem::bad_option, sentence + " (see straightedge " + command + "--help)"});
}

int print(const std::string& text) {
  const auto written = write_stdout(text);
  return written ? 0 : fail(written.failure());
}

std::string input_of(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() && option->count() > 0) return option->results().front();
  }
  return command.get_name();
}

int run_command(const Command& command) try {
  const auto done = command.run();
  return done ? 0 : fail(done.failure());
} catch (const std::bad_alloc&) {
  return fail({Problem::internal, input_of(*command.app) + ": there is not enough memory for this input"});
}

int run_commands(CLI::App& program, int argument_count, char** arguments) {
  const std::vector<Command> commands = {
      add_edges_command(program), add_hough_command(program),    add_explain_command(program),
      add_lines_command(program), add_planes_command(program),   add_localize_command(program),
      add_show_command(program),  add_validate_command(program), add_merge_command(program)};
  try {
    program.parse(argument_count, arguments);
  } catch (const CLI::CallForHelp&) {
    return print(program.help());
  } catch (const CLI::CallForVersion& version) {
    return print(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    return fail_usage(program, error, argument_count > 1 ? arguments[1] : "");
  }
  for (const Command& command : commands) {
    if (!command.app->parsed()) continue;
    if (const auto kernels = kernels_from_environment(); !kernels) return fail(kernels.failure());
    return run_command(command);
  }
  return fail({Problem::bad_option, "no sub-command was given"});
}

}  // namespace

std::string version_text() {
  return "straightedge " STRAIGHTEDGE_VERSION;
}

int run_program(int argument_count, char** arguments) try {
  // A reader that leaves early shall give a sentence, not a silent end.
  std::signal(SIGPIPE, SIG_IGN);
  CLI::App program("Line maps from images, plane maps from depth frames, robots found in line maps.",
                   "straightedge");
  program.set_version_flag("--version", version_text(), "print the version and leave");
  program.formatter(std::make_shared<HelpFormat>());
  program.require_subcommand(1);
  program.footer(exit_codes_text);
  return run_commands(program, argument_count, arguments);
} catch (const std::bad_alloc&) {
  return fail({Problem::internal, "there is not enough memory"});
} catch (const std::exception& error) {
  return fail({Problem::internal, std::string("internal fault: ") + error.what()});
}

}  // namespace straightedge::cli
