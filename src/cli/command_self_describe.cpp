// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

#include "cli/commands.h"
#include "cli/completion.h"
#include "cli/exit_code.h"
#include "cli/man_page.h"
#include "core/atomic_file.h"
#include "core/error.h"

namespace poinsot::cli {
namespace {

namespace fs = std::filesystem;

void put(const fs::path& file, const std::string& text) {
  std::error_code ignored;  // if a folder cannot be made, writing the file says so
  fs::create_directories(file.parent_path(), ignored);
  core::writeFileAtomically(file, std::string_view(text));
}

/// The places below share/ where man and the shells look.
int selfDescribe(const CLI::App& program, const fs::path& share) {
  const ProgramText text = textOf(program);
  const fs::path manuals = share / "man" / "man1";
  put(manuals / manPageName(text.program), manPage(text, text.program));
  for (const CommandText& command : text.commands) put(manuals / manPageName(command), manPage(text, command));
  put(share / "bash-completion" / "completions" / "poinsot", bashCompletion(text));
  put(share / "zsh" / "vendor-completions" / "_poinsot", zshCompletion(text));
  put(share / "fish" / "vendor_completions.d" / "poinsot.fish", fishCompletion(text));
  return kDone;
}

}  // namespace

void addSelfDescribe(CLI::App& program, Action& chosen) {
  auto share = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("self-describe", "write man pages and completions into a folder");
  command->group("");  // not in the help: the build runs it
  command->add_option("FOLDER", *share, "laid out as share/ of an installed program")->required();
  command->callback(
      [share, &program, &chosen] { chosen.run = [share, &program] { return selfDescribe(program, *share); }; });
}

}  // namespace poinsot::cli
