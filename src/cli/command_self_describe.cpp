// SPDX-License-Identifier: Apache-2.0
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
  std::error_code ignored;  // ignored: writing the file reports a missing folder
  fs::create_directories(file.parent_path(), ignored);
  core::writeFileAtomically(file, std::string_view(text));
}

/// Writes man pages and shell completions to their usual folders below `share`.
int selfDescribe(const Command& program, const fs::path& share) {
  const ProgramText text = textOf(program.parser());
  const fs::path manuals = share / "man" / "man1";
  put(manuals / manPageName(text.program), manPage(text, text.program));
  for (const CommandText& command : text.commands) put(manuals / manPageName(command), manPage(text, command));
  put(share / "bash-completion" / "completions" / "poinsot", bashCompletion(text));
  put(share / "zsh" / "vendor-completions" / "_poinsot", zshCompletion(text));
  put(share / "fish" / "vendor_completions.d" / "poinsot.fish", fishCompletion(text));
  return kDone;
}

}  // namespace

void addSelfDescribe(const Command& program) {
  auto share = std::make_shared<std::string>();
  const Command command = program.command("self-describe", "write man pages and completions into a folder");
  command.hide();  // for use by the build only
  command.option("FOLDER", *share, "folder to write to, laid out like share/ of an installed program").required();
  command.does({[share, program] { return selfDescribe(program, *share); }});
}

}  // namespace poinsot::cli
