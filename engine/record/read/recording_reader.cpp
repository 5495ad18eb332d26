#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/files/source.h>
#include <graze/engine/record/read/recording_data.h>
#include <graze/engine/record/shapes/shape_content.h>

#include <cmath>
#include <fstream>
#include <system_error>
#include <utility>

namespace graze {
namespace {

using record::Block;
using record::BlockKind;
using record::ByteReader;

WorldSettings read_world_settings(ByteReader& from) {
  WorldSettings settings;
  settings.threads = static_cast<int>(from.number_up_to(0x7fffffff, "threads"));
  const unsigned bits = from.flags(31, "settings");
  settings.contacts = (bits & 1) != 0;
  settings.islands = (bits & 2) != 0;
  settings.skip_apart = (bits & 4) != 0;
  settings.skip_at_rest = (bits & 8) != 0;
  settings.skip_unused_trees = (bits & 16) != 0;
  settings.number = from.number_up_to(kLargestWorldNumber, "number of the world");
  settings.sweeps.clearance = from.real(), settings.sweeps.tolerance = from.real();
  settings.sweeps.budget = from.number();
  settings.sliding_depth = from.real();
  return settings;
}

std::unique_ptr<std::istream> open(const std::filesystem::path& file) {
  const std::string name = mesh_io::printable(file.string());
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw RecordingError(name + ": is a folder", {.file = file.string(), .element = {}});
  auto stream = std::make_unique<std::ifstream>(file, std::ios::binary);
  if (!*stream)
    throw RecordingError(name + ": cannot be read", {.file = file.string(), .element = {}});
  return stream;
}

/// Reads a shape or a pose; if it is refused the file is damaged.
template <typename Read>
void at_block(const Block& block, const record::BlockReader& blocks, const Read& read) {
  try {
    read();
  } catch (const RecordingError&) {
    throw;
  } catch (const Error& error) {
    blocks.fail(block.offset, error.what());
  }
}

}  // namespace

void RecordingReader::Data::read_head() {
  if (!blocks.read(block)) blocks.fail(blocks.bytes(), "ends before there is a world");
  if (block.kind != BlockKind::Head) blocks.fail(block.offset, "does not begin with a head");
  ByteReader from(block.content, name, block.offset);
  head.engine_version = from.text();
  head.note = from.text();
  head.seconds_per_update = from.real();
  if (!(head.seconds_per_update >= 0) || !std::isfinite(head.seconds_per_update))
    from.fail("seconds per update are none");
  const std::uint8_t contacts = from.byte();
  if (contacts > static_cast<std::uint8_t>(RecordedContacts::All))
    from.fail("contacts of an unknown kind");
  head.contacts = static_cast<RecordedContacts>(contacts);
  head.has_work = from.flags(1, "work") != 0;
  head.world = read_world_settings(from);
  from.require_end();
  while (start == nullptr) {
    if (!blocks.read(block)) blocks.fail(blocks.bytes(), "ends before there is a world");
    if (block.kind == BlockKind::Shape) {
      read_shape(block);
    } else if (block.kind == BlockKind::State) {
      at_block(block, blocks, [&] {
        ByteReader state(block.content, name, block.offset);
        start = read_contents(state);
        state.require_end();
      });
    } else {
      blocks.fail(block.offset, "has no world at its beginning");
    }
  }
}

void RecordingReader::Data::read_shape(const Block& from_block) {
  at_block(from_block, blocks, [&] {
    ByteReader outer(from_block.content, name, from_block.offset);
    const std::string content = record::unpacked(outer);
    ByteReader from(content, name, from_block.offset, true);
    shapes.push_back(record::read_body_shape(from, [&](std::uint32_t number) {
      return number < shapes.size() ? shapes[number]->shape() : nullptr;
    }));
    from.require_end();
  });
}

void RecordingReader::Data::read_step(const Block& from_block) {
  at_block(from_block, blocks, [&] {
    ByteReader from(from_block.content, name, from_block.offset);
    step = {};
    step.number = steps;
    step.changes = read_changes(from);
    step.follows_failure = from.flags(1, "an update") != 0;
    read_refused(from);
    step.answers = record::read_answers(from, ids, head.has_work);
    from.require_end();
    ++steps;
  });
}

void RecordingReader::Data::read_end(const Block& from_block) {
  ByteReader from(from_block.content, name, from_block.offset);
  if (from.number() != steps) from.fail("updates are missing");
  from.require_end();
  if (stream->peek() != std::istream::traits_type::eof())
    blocks.fail(blocks.bytes(), "goes on behind its end");
  end = RecordingEnd::Complete;
}

RecordingReader::RecordingReader(const std::filesystem::path& file)
    : RecordingReader(open(file), file.string()) {}

RecordingReader::RecordingReader(std::unique_ptr<std::istream> stream, std::string name) {
  bvh::in_standard_arithmetic([&] {
    if (stream == nullptr) throw InputError("recording: there is no stream");
    data_ = std::make_unique<Data>(std::move(stream), std::move(name));
    data_->read_head();
  });
}

RecordingReader::~RecordingReader() = default;
RecordingReader::RecordingReader(RecordingReader&& other) noexcept = default;
RecordingReader& RecordingReader::operator=(RecordingReader&& other) noexcept = default;

const RecordingHead& RecordingReader::head() const {
  return data_->head;
}

const RecordedState& RecordingReader::start() const {
  return *data_->start;
}

const RecordedStep* RecordingReader::next() {
  return bvh::in_standard_arithmetic([&]() -> const RecordedStep* {
    Data& data = *data_;
    if (data.has_failed) data.blocks.fail(data.blocks.bytes(), "is damaged, as was said before");
    if (data.end != RecordingEnd::NotReached) return nullptr;
    data.has_failed = true;
    const RecordedStep* read = nullptr;
    while (read == nullptr && data.end == RecordingEnd::NotReached) {
      if (!data.blocks.read(data.block)) {
        data.end = RecordingEnd::CutOff;
      } else if (data.block.kind == BlockKind::Shape) {
        data.read_shape(data.block);
      } else if (data.block.kind == BlockKind::Step) {
        data.read_step(data.block);
        read = &data.step;
      } else if (data.block.kind == BlockKind::End) {
        data.read_end(data.block);
      } else {
        data.blocks.fail(data.block.offset, "a block where none of its kind belongs");
      }
    }
    data.has_failed = false;
    return read;
  });
}

RecordingEnd RecordingReader::end() const {
  return data_->end;
}

std::uint64_t RecordingReader::bytes() const {
  return data_->blocks.bytes();
}

std::size_t RecordingReader::shape_count() const {
  return data_->shapes.size();
}

const std::shared_ptr<const BodyShape>& RecordingReader::shape(std::uint32_t number) const {
  if (number >= data_->shapes.size()) {
    throw InputError("recording: there is no shape " + std::to_string(number) + ", but " +
                         std::to_string(data_->shapes.size()),
                     {.element = "shape", .index = number});
  }
  return data_->shapes[number];
}

}  // namespace graze
