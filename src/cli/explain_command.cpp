// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <climits>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/depth_camera.hpp"
#include "cli/explain_arguments.hpp"
#include "cli/explain_depth.hpp"
#include "cli/explain_image.hpp"
#include "cli/map_source.hpp"
#include "cli/outputs.hpp"
#include "cli/picture_input.hpp"
#include "cli/program.hpp"
#include "cli/progress.hpp"
#include "cli/streams.hpp"
#include "io/read_bytes.hpp"
#include "straightedge/host/depth_file.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

Json json_head(const ExplainArguments& arguments, const fs::path& picture, const char* kind, Size size) {
  return {{"program", version_text()},     {"command", "explain"},
          {"input", base_name(picture)},   {"kind", kind},
          {"width", size.width},           {"height", size.height},
          {"seed", arguments.common.seed}, {"page", (fs::path(arguments.folder) / "index.html").string()}};
}

std::string text_of(const Json& numbers) {
  return numbers.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Sentences about outputs name their file themselves.
Result<Done> named(const Result<Done>& done, const fs::path& picture) {
  if (done || done.failure().problem == Problem::cannot_write) return done;
  return Failure{done.failure().problem, picture.string() + ": " + done.failure().sentence};
}

std::size_t pixels_of(Size size) {
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

Result<Done> finish(const ExplainArguments& arguments, const fs::path& picture, const Json& numbers) {
  if (!arguments.common.quiet) {
    print_words(picture.string() + ": explained; open " +
                (fs::path(arguments.folder) / "index.html").string());
  }
  return arguments.common.json ? write_stdout(text_of(numbers)) : Done{};
}

Result<Done> explain_lines(const ExplainArguments& arguments, const MapSource& source,
                           std::string_view bytes) {
  // First of all: a depth frame that is cut short is no picture with wrong options.
  const auto gray = decode_picture(bytes, source.picture);
  if (!gray) return gray.failure();
  auto options = arguments.line_options();
  if (!options) return options.failure();
  options->meaning = source.meaning;
  const std::size_t work = Canny::workspace_bytes(gray->size(), options->canny) +
                           HoughLines::workspace_bytes(gray->size(), *options->hough);
  if (auto fits = check_memory(source.picture, work + 40 * pixels_of(gray->size())); !fits) return fits;
  {
    const Progress progress(source.picture.string() + ": explaining", arguments.common.quiet);
    const auto done = explain_image(
        *gray, {.lines = *options, .input = base_name(source.picture), .version = STRAIGHTEDGE_VERSION},
        arguments.folder);
    if (!done) return named(done, source.picture);
  }
  Json numbers = json_head(arguments, source.picture, "picture", gray->size());
  numbers["options"] = words_of(*options);
  return finish(arguments, source.picture, numbers);
}

/// As the camera without distortion would have seen it.
Result<Image<std::uint16_t>> straightened(const fs::path& picture, Image<std::uint16_t> raw,
                                          const DepthCamera& camera) {
  if (camera.size && *camera.size != raw.size())
    return Failure{Problem::bad_content, picture.string() + ": is not of the size that its camera states"};
  if (camera.distortion.none()) return raw;
  return undistorted(raw, camera);
}

Result<Done> explain_planes(const ExplainArguments& arguments, const fs::path& picture,
                            Image<std::uint16_t> raw) {
  const auto options = arguments.plane_options();
  if (!options) return options.failure();
  const auto camera = find_depth_camera(picture, arguments.camera, arguments.units_per_metre());
  if (!camera) return camera.failure();
  const auto frame = straightened(picture, std::move(raw), *camera);
  if (!frame) return frame.failure();
  const std::size_t work = 2 * FramePlanes::workspace_bytes(frame->size(), options->frame);
  if (auto fits = check_memory(picture, work + 40 * pixels_of(frame->size())); !fits) return fits;
  {
    const Progress progress(picture.string() + ": explaining", arguments.common.quiet);
    const auto done =
        explain_depth({*frame, camera->metres_per_unit(), camera->pinhole},
                      {.detector = *options, .input = base_name(picture), .version = STRAIGHTEDGE_VERSION},
                      arguments.folder);
    if (!done) return named(done, picture);
  }
  Json numbers = json_head(arguments, picture, "depth", frame->size());
  numbers["options"] = options->method == PlaneMethod::ransac ? "method ransac" : "method hough";
  return finish(arguments, picture, numbers);
}

Result<Done> run(const ExplainArguments& arguments) {
  if (arguments.folder.empty())
    return Failure{Problem::bad_option, "--output: the name of the folder is empty"};
  const auto source = find_map_source(arguments.input);
  if (!source) return source.failure();
  const auto bytes = io::read_bytes(source->picture, INT_MAX);
  if (!bytes) return bytes.failure();
  if (!source->meaning && !arguments.wants_picture()) {
    auto depth = decode_depth_image(*bytes, source->picture.string());
    if (depth) return explain_planes(arguments, source->picture, std::move(*depth));
  }
  return explain_lines(arguments, *source, *bytes);
}

}  // namespace

Command add_explain_command(CLI::App& program) {
  const auto arguments = std::make_shared<ExplainArguments>();
  CLI::App& command = *program.add_subcommand("explain",
                                              "Every stage from a picture to its line map, or from a depth "
                                              "frame to its planes, as a picture, with a\n"
                                              "page that tells what each shows");
  arguments->add_to(command);
  add_common_options(command, arguments->common, "kind, size, options and the name of the page");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace straightedge::cli
