#include <graze/bvh/error.h>
#include <graze/engine/compare/run/poses/block_cache.h>
#include <graze/engine/compare/run/poses/pose_source.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/pose_array.h>
#include <graze/engine/mesh/io/pose_lines.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/pose_text.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <utility>

namespace graze::compare {
namespace {

/// So many poses are read, and summed up, at a time.
constexpr std::size_t kBlock = 1024;

/// Sums up many poses, a block at a time: the sum is the SHA-256 of those of the blocks.
class PoseSum {
 public:
  void add(const Pose& pose) {
    for (int i = 0; i < 12; ++i) {
      const auto bits = std::bit_cast<std::uint64_t>(pose(i / 4, i % 4));
      for (int byte = 0; byte < 8; ++byte)
        block_ += static_cast<char>(bits >> (8 * byte) & 255);
    }
    if (++count_ % kBlock == 0) close();
  }
  std::string sum() {
    close();
    return files::sha256_of(sums_);
  }

 private:
  void close() {
    sums_ = files::sha256_of(sums_ + block_);
    block_.clear();
  }

  std::string block_;
  std::string sums_;
  std::size_t count_ = 0;
};

class PoseList : public PoseSource {
 public:
  explicit PoseList(std::vector<Pose> poses) : poses_(std::move(poses)) {
    PoseSum sum;
    for (const Pose& pose : poses_)
      sum.add(pose);
    key_ = sum.sum();
  }
  std::size_t size() const override { return poses_.size(); }
  Pose at(std::size_t place) const override { return poses_[place]; }
  const std::string& key() const override { return key_; }

 private:
  std::vector<Pose> poses_;
  std::string key_;
};

class ArrayFile {
 public:
  /// Opens an array; nothing unless the file is regular and begins as an array does.
  static std::shared_ptr<const ArrayFile> open(const std::filesystem::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (descriptor < 0) return nullptr;
    auto file = std::make_shared<ArrayFile>(path, descriptor);
    struct stat status = {};
    if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return nullptr;
    const auto size = static_cast<std::size_t>(status.st_size);
    const std::string begin = file->read(0, std::min(size, mesh_io::kMostArrayHeader));
    if (!mesh_io::is_array(begin)) return nullptr;
    file->layout_ = mesh_io::layout_of_array(begin, size, file->name_);
    if (file->layout_.count == 0)
      throw PoseError(file->name_ + ": no poses", {.file = file->name_});
    return file;
  }

  ArrayFile(const std::filesystem::path& path, int descriptor)
      : name_(mesh_io::printable(path.string())), descriptor_(descriptor) {}
  ~ArrayFile() { close(descriptor_); }
  ArrayFile(const ArrayFile&) = delete;
  ArrayFile& operator=(const ArrayFile&) = delete;

  std::size_t size() const { return layout_.count; }

  std::vector<Pose> block(std::size_t block) const {
    const std::size_t first = block * kBlock;
    const std::size_t count = std::min(kBlock, layout_.count - first);
    const std::size_t each = layout_.bytes_of_pose();
    const std::string bytes = read(layout_.start + first * each, count * each);
    std::vector<Pose> poses;
    poses.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      poses.push_back(
          mesh_io::pose_of_array(std::string_view(bytes).substr(i * each, each), first + i, name_));
    }
    return poses;
  }

  const std::string& name() const { return name_; }

 private:
  std::string read(std::size_t at, std::size_t size) const {
    std::string bytes(size, '\0');
    for (std::size_t done = 0; done < size;) {
      const ssize_t count =
          pread(descriptor_, bytes.data() + done, size - done, static_cast<off_t>(at + done));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) {
        const char* why = count < 0 ? std::strerror(errno) : "is shorter than it was";
        throw PoseError(name_ + ": " + why, {.file = name_});
      }
      done += static_cast<std::size_t>(count);
    }
    return bytes;
  }

  std::string name_;
  int descriptor_;
  mesh_io::PoseArrayLayout layout_;
};

class ArrayPoses : public PoseSource {
 public:
  ArrayPoses(std::shared_ptr<const ArrayFile> file, const Aabb& bounds_b)
      : file_(std::move(file)), blocks_([this](std::size_t block) { return file_->block(block); }) {
    PoseSum sum;
    for (std::size_t first = 0; first < file_->size(); first += kBlock) {
      std::size_t number = first;
      for (const Pose& pose : file_->block(first / kBlock)) {
        const std::string place = file_->name() + ":" + std::to_string(++number);
        check_placement(pose, bounds_b, place.c_str());
        sum.add(pose);
      }
    }
    key_ = sum.sum();
  }

  std::size_t size() const override { return file_->size(); }
  Pose at(std::size_t place) const override {
    return (*blocks_.at(place / kBlock))[place % kBlock];
  }
  const std::string& key() const override { return key_; }

 private:
  std::shared_ptr<const ArrayFile> file_;
  std::string key_;
  BlockCache<Pose> blocks_;
};

/// Reads poses from a file of text, and keeps where each block begins in it.
class TextPoses : public PoseSource {
 public:
  TextPoses(std::filesystem::path path, const Aabb& bounds_b)
      : path_(std::move(path)),
        name_(mesh_io::printable(path_.string())),
        blocks_([this](std::size_t block) { return poses_of(block); }) {
    std::ifstream file = opened();
    mesh_io::PoseLines lines(file, name_);
    PoseSum sum;
    PoseLine line;
    for (;; ++size_) {
      const Start here{file.tellg(), lines.next_line()};
      if (!lines.next(line)) break;
      if (size_ % kBlock == 0) starts_.push_back(here);
      const std::string place = name_ + ":" + std::to_string(line.line);
      check_placement(line.pose, bounds_b, place.c_str());
      sum.add(line.pose);
    }
    if (size_ == 0) throw PoseError(name_ + ": no poses", {.file = name_});
    key_ = sum.sum();
  }

  std::size_t size() const override { return size_; }
  Pose at(std::size_t place) const override {
    return (*blocks_.at(place / kBlock))[place % kBlock];
  }
  const std::string& key() const override { return key_; }

 private:
  struct Start {
    std::streampos place;
    std::size_t line;
  };

  std::ifstream opened() const {
    std::ifstream file(path_, std::ios::binary);
    if (!file) throw PoseError(name_ + ": " + std::strerror(errno), {.file = name_});
    return file;
  }

  std::vector<Pose> poses_of(std::size_t block) const {
    std::ifstream file = opened();
    file.seekg(starts_[block].place);
    mesh_io::PoseLines lines(file, name_, starts_[block].line);
    const std::size_t count = std::min(kBlock, size_ - block * kBlock);
    std::vector<Pose> poses;
    for (PoseLine line; poses.size() < count && lines.next(line);)
      poses.push_back(line.pose);
    if (poses.size() < count) {
      throw PoseError(name_ + ": is shorter than it was", {.file = name_});
    }
    return poses;
  }

  std::filesystem::path path_;
  std::string name_;
  std::size_t size_ = 0;
  std::vector<Start> starts_;
  std::string key_;
  BlockCache<Pose> blocks_;
};

/// True for a file that can be read from any place, and is no array, which an error of its own
/// would tell.
bool is_text_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  std::ifstream file(path, std::ios::binary);
  constexpr int kFirstOfArray = 0x93;
  return file && file.peek() != kFirstOfArray;
}

}  // namespace

std::shared_ptr<const PoseSource> pose_list(std::vector<Pose> poses) {
  return std::make_shared<PoseList>(std::move(poses));
}

std::shared_ptr<const PoseSource> pose_file(const std::filesystem::path& path,
                                            const Aabb& bounds_b) {
  if (std::shared_ptr<const ArrayFile> array = ArrayFile::open(path)) {
    return std::make_shared<ArrayPoses>(std::move(array), bounds_b);
  }
  if (is_text_file(path)) return std::make_shared<TextPoses>(path, bounds_b);
  std::vector<Pose> poses;
  const std::string name = mesh_io::printable(path.string());
  for (const PoseLine& line : load_pose_lines(path)) {
    const std::string place = name + ":" + std::to_string(line.line);
    check_placement(line.pose, bounds_b, place.c_str());
    poses.push_back(line.pose);
  }
  return pose_list(std::move(poses));
}

}  // namespace graze::compare
