#pragma once

#include <graze/engine/mesh/rigid_certificate.h>
#include <graze/engine/mesh/rigid_motion.h>

#include <filesystem>
#include <string>

namespace graze::cli {

/// Holds a proof that two meshes stay apart in rigid motion, with what it is about.
struct CertificateFile {
  std::filesystem::path mesh_a;  ///< relative to the folder of the certificate, or absolute
  std::filesystem::path mesh_b;  ///< relative to the folder of the certificate, or absolute
  RigidMotion motion_a;
  RigidMotion motion_b;
  FreedomCertificate certificate;
};

/// Returns JSON whose numbers are hex floats, so that they are read back bit for bit.
std::string to_json(const CertificateFile& file);

/// Reads a certificate. Throws CaseError `file:line: /place: why` for an invalid one, and MeshError
/// for a file that cannot be read. Whether the proof holds is another question.
CertificateFile read_certificate(const std::filesystem::path& path);

}  // namespace graze::cli
