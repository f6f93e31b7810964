// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/explain_files.hpp"
#include "cli/localize_report.hpp"
#include "cli/outputs.hpp"

namespace straightedge::cli {

/// The files of a run: checked before the work, filled after it, then written, each whole or not at all.
class LocalizeOutputs {
 public:
  explicit LocalizeOutputs(const LocalizeArguments& arguments);

  Result<Done> check() const;
  Result<Done> fill(const LocalizeStory& story);
  Result<Done> write() const;
  std::string names() const;

 private:
  const LocalizeArguments& arguments_;
  std::vector<Output> outputs_;
  std::vector<NamedFile> pictures_;
};

}  // namespace straightedge::cli
