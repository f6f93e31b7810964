// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "source_rules.hpp"

namespace project {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

// The table of the tree: module -> modules it may include besides itself. "host" are public headers that
// belong to no module of their own, such as the image that owns its pixels.
const std::map<std::string, Names> may_include = {
    {"base", {}},
    {"canny", {"base"}},
    {"fit", {"base"}},
    {"hough", {"base", "fit"}},
    {"ransac", {"base", "fit"}},
    {"octree", {"base"}},
    {"host", {"base", "canny", "fit", "hough", "ransac", "octree"}},
    {"map", {"base", "canny", "fit", "hough", "ransac", "octree", "host"}},
    {"localize", {"base", "fit", "hough", "ransac", "map", "host"}},
    {"io", {"base", "canny", "fit", "map", "host"}},
    {"cli", {"base", "canny", "fit", "hough", "ransac", "octree", "host", "map", "localize", "io"}},
};
const Names core_modules = {"base", "canny", "fit", "hough", "ransac", "octree"};

// Standard headers that need neither heap nor run-time support.
const Names core_headers = {"algorithm", "array",   "bit",     "climits", "compare",     "concepts",
                            "cstddef",   "cstdint", "cstring", "limits",  "new",         "numeric",
                            "span",      "tuple",   "utility", "version", "type_traits", "iterator"};

// Other people's libraries, and a processor's own functions, with the modules or folders that may see each.
const std::map<std::string, Names> library_users = {
    {"tinyxml2.h", {"io"}},
    {"stb", {"io"}},
    {"png.h", {"io"}},
    {"zlib.h", {"io"}},
    {"yaml-cpp/", {"io"}},
    {"CLI/", {"cli"}},
    {"nlohmann/", {"cli", "io"}},
    {"Eigen/", {"map"}},
    {"immintrin.h", {"canny/fast", "fit/fast", "octree/fast", "ransac/fast"}},
    {"emmintrin.h", {"canny/fast"}},
    {"opencv", {}},
    {"boost/", {}},
    {"pcl/", {}},
};

// The module whose name starts the header's, or that has a .cpp of the header's name or of words it begins
// with. A header in host/ belongs to a host module or to "host".
std::string owner_of_public_header(const fs::path& root, const fs::path& header) {
  const std::string stem = header.stem().string();
  const bool host = header.parent_path().filename() == "host";
  for (const auto& [module, allowed] : may_include) {
    if (core_modules.contains(module) == host) continue;
    if (!host && (stem == module || stem.starts_with(module + "_"))) return module;
    for (std::string name = stem; !name.empty();) {
      if (fs::exists(root / "src" / module / (name + ".cpp"))) return module;
      const std::size_t end = name.rfind('_');
      name = end == std::string::npos ? "" : name.substr(0, end);
    }
  }
  return host ? "host" : "base";
}

std::optional<std::string> module_of_include(const fs::path& root, const fs::path& from_module,
                                             const fs::path& from_file, const std::string& name) {
  const fs::path path = name;
  if (name.starts_with("straightedge/")) {
    if (!fs::exists(root / "include" / path)) return std::nullopt;
    return owner_of_public_header(root, path);
  }
  const std::string first = path.begin()->string();
  if (may_include.contains(first) && fs::exists(root / "src" / path)) return first;
  if (fs::exists(from_file.parent_path() / path)) return from_module.string();
  return std::nullopt;
}

std::optional<std::string> objection_to_own(const std::string& module,
                                            const std::optional<std::string>& target,
                                            const std::string& name) {
  if (!target) return "includes \"" + name + "\", which is not in the tree";
  if (*target == module || may_include.at(module).contains(*target)) return std::nullopt;
  return module + " may not include " + name + " of " + *target;
}

std::optional<std::string> objection_to_foreign(const std::string& module, const std::string& folder,
                                                bool is_public, const std::string& name) {
  for (const auto& [library, users] : library_users) {
    if (!name.starts_with(library)) continue;
    if (is_public) return "a public header may not include <" + name + ">";
    if (users.contains(module) || users.contains(folder)) return std::nullopt;
    return module + " may not include <" + name + ">";
  }
  if (core_modules.contains(module) && !core_headers.contains(name)) {
    return "the core may not include <" + name + ">";
  }
  return std::nullopt;
}

struct Include {
  std::string name;
  bool quoted = false;
};

// What a line includes, if it does: # include <name> or "name", blanks allowed.
std::optional<Include> include_on(const std::string& line) {
  std::size_t at = 0;
  const auto skip = [&](const std::string& word) {
    at = std::min(line.find_first_not_of(" \t", at), line.size());
    if (line.compare(at, word.size(), word) != 0) return false;
    at += word.size();
    return true;
  };
  if (!skip("#") || !skip("include") || !skip("")) return std::nullopt;
  const std::size_t end = line.find_first_of(">\"", at + 1);
  if (at >= line.size() || end == std::string::npos) return std::nullopt;
  return Include{line.substr(at + 1, end - at - 1), line[at] == '"'};
}

void check_file(const fs::path& root, const fs::path& file, const std::string& module, bool is_public,
                std::vector<Breach>& breaches) {
  const std::vector<std::string> lines = lines_of(file);
  const std::string folder = fs::relative(file.parent_path(), root / "src").generic_string();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto include = include_on(lines[i]);
    if (!include) continue;
    const std::string& name = include->name;
    const auto objection = include->quoted
                               ? objection_to_own(module, module_of_include(root, module, file, name), name)
                               : objection_to_foreign(module, folder, is_public, name);
    if (objection) breaches.push_back({fs::relative(file, root).string(), i + 1, *objection});
  }
}

}  // namespace

std::vector<Breach> include_breaches(const fs::path& root) {
  std::vector<Breach> breaches;
  for (const fs::path& file : files_below(root / "src", {".hpp", ".cpp"})) {
    const std::string module = fs::relative(file, root / "src").begin()->string();
    if (may_include.contains(module)) {
      check_file(root, file, module, false, breaches);
    } else {
      breaches.push_back(
          {fs::relative(file, root).string(), 0, "the table of modules does not know " + module});
    }
  }
  for (const fs::path& file : files_below(root / "include", {".hpp"})) {
    check_file(root, file, owner_of_public_header(root, file), true, breaches);
  }
  return breaches;
}

}  // namespace project
