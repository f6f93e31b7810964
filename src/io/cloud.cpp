// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/cloud.hpp"

#include <new>

#include "io/cloud_text.hpp"
#include "io/pcd.hpp"
#include "io/ply_read.hpp"
#include "io/read_bytes.hpp"

namespace straightedge {

Result<Cloud> cloud_from_bytes(std::string_view bytes, const std::string& name) try {
  if (io::is_ply(bytes)) return io::decode_ply(bytes);
  if (io::is_pcd(bytes)) return io::decode_pcd(bytes);
  return Failure{Problem::bad_content, name + ": is neither a PCD nor a PLY file"};
} catch (const io::CloudBreach& breach) {
  return Failure{Problem::bad_content, name + ": " + breach.sentence};
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_read, name + ": does not fit into memory"};
}

Result<Cloud> read_cloud(const std::filesystem::path& file) {
  const auto bytes = io::read_bytes(file, max_cloud_file_bytes);
  if (!bytes) return bytes.failure();
  return cloud_from_bytes(*bytes, file.string());
}

}  // namespace straightedge
