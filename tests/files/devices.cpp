#include "tests/files/devices.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace graze::tests {

std::string spare_device(Device device, const std::filesystem::path& folder) {
  const bool is_full = device == Device::Full;
  std::string path = is_full ? "/dev/full" : "/dev/null";
  if (geteuid() == 0) {
    constexpr unsigned kMemoryDevices = 1;
    path = folder / (is_full ? "device_full" : "device_null");
    mknod(path.c_str(), S_IFCHR | 0600, makedev(kMemoryDevices, is_full ? 7 : 3));
  }
  // What is mounted without devices has them by name only.
  const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return "";
  close(descriptor);
  return path;
}

}  // namespace graze::tests
