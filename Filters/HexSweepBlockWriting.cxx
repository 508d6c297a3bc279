// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepBlockWriting.h"

#include "HexSweepBase64.h"

#include <vtkDataCompressor.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <ostream>
#include <vector>

namespace hexsweep
{
namespace
{
using Bytes = std::vector<unsigned char>;

constexpr std::size_t BlocksAtOnce = 256;
/// Bytes that a thread encodes at a time, in threes.
constexpr std::size_t EncodedAtOnce = 3 << 16;

/// Numbers of one block, narrowed where they are to be.
void narrow(const BlockValues& values, std::size_t first, std::size_t count, Bytes& narrowed)
{
  narrowed.resize(count * sizeof(std::int32_t));
  const unsigned char* from = values.data + first * sizeof(std::int64_t);
  for (std::size_t i = 0; i < count; ++i)
  {
    std::int64_t wide = 0;
    std::memcpy(&wide, from + i * sizeof wide, sizeof wide);
    const auto half = static_cast<std::int32_t>(wide);
    std::memcpy(narrowed.data() + i * sizeof half, &half, sizeof half);
  }
}

/// A block as it is compressed; empty where that went wrong.
void compress(
  const BlockValues& values, std::size_t block, vtkDataCompressor* compressor, Bytes& compressed)
{
  const std::size_t first = block * values.perBlock;
  const std::size_t count = std::min(values.perBlock, values.count - first);
  const unsigned char* data = values.data + first * values.size;
  Bytes narrowed;
  if (values.halved)
  {
    narrow(values, first, count, narrowed);
    data = narrowed.data();
  }
  const std::size_t size = count * values.writtenSize();
  compressed.resize(compressor->GetMaximumCompressionSpace(size));
  compressed.resize(compressor->Compress(data, size, compressed.data(), compressed.size()));
}

/// Takes bytes a few blocks at a time; what does not fill three of them waits for the next.
class Base64Stream
{
public:
  explicit Base64Stream(std::ostream& stream)
    : Stream(stream)
  {
  }

  void write(const std::vector<Bytes>& blocks, std::size_t count, bool last)
  {
    for (std::size_t b = 0; b < count; ++b)
    {
      this->Waiting.insert(this->Waiting.end(), blocks[b].begin(), blocks[b].end());
    }
    const std::size_t size = last ? this->Waiting.size() : this->Waiting.size() / 3 * 3;
    this->Text.resize(base64Size(size));
    const auto pieces = static_cast<vtkIdType>((size + EncodedAtOnce - 1) / EncodedAtOnce);
    vtkSMPTools::For(0, pieces, 1, [&](vtkIdType begin, vtkIdType end) {
      for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
      {
        const std::size_t first = p * EncodedAtOnce;
        encodeBase64(this->Waiting.data() + first, std::min(EncodedAtOnce, size - first),
          this->Text.data() + base64Size(first));
      }
    });
    this->Stream.write(this->Text.data(), static_cast<std::streamsize>(this->Text.size()));
    this->Waiting.erase(
      this->Waiting.begin(), this->Waiting.begin() + static_cast<std::ptrdiff_t>(size));
  }

private:
  std::ostream& Stream;
  Bytes Waiting;
  std::vector<char> Text;
};

/// How many blocks, the size of each but the last, that of the last where it is shorter, and all
/// sizes compressed.
template <typename Word>
std::vector<char> headerText(const BlockValues& values, const std::vector<std::size_t>& sizes)
{
  const std::size_t rest = values.count % values.perBlock;
  std::vector<Word> words{ static_cast<Word>(sizes.size()),
    static_cast<Word>(values.perBlock * values.writtenSize()),
    static_cast<Word>(rest * values.writtenSize()) };
  words.insert(words.end(), sizes.begin(), sizes.end());
  Bytes bytes(words.size() * sizeof(Word));
  std::memcpy(bytes.data(), words.data(), bytes.size());
  std::vector<char> text(base64Size(bytes.size()));
  encodeBase64(bytes.data(), bytes.size(), text.data());
  return text;
}
}

bool writeBlocks(
  const BlockValues& values, vtkDataCompressor* compressor, int headerBits, std::ostream& stream)
{
  std::vector<std::size_t> sizes(values.blocks(), 0);
  const auto writeHeader = [&] {
    const std::vector<char> text = headerBits == 64 ? headerText<std::uint64_t>(values, sizes)
                                                    : headerText<std::uint32_t>(values, sizes);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  };
  const std::ostream::pos_type start = stream.tellp();
  writeHeader();
  Base64Stream text(stream);
  std::vector<Bytes> compressed(std::min(BlocksAtOnce, sizes.size()));
  for (std::size_t first = 0; first < sizes.size(); first += BlocksAtOnce)
  {
    const std::size_t count = std::min(BlocksAtOnce, sizes.size() - first);
    // VTK's compressors know nothing of one call in the next.
    vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1, [&](vtkIdType begin, vtkIdType end) {
      for (auto b = static_cast<std::size_t>(begin); b < static_cast<std::size_t>(end); ++b)
      {
        compress(values, first + b, compressor, compressed[b]);
      }
    });
    for (std::size_t b = 0; b < count; ++b)
    {
      sizes[first + b] = compressed[b].size();
    }
    text.write(compressed, count, first + count == sizes.size());
  }
  const std::ostream::pos_type end = stream.tellp();
  stream.seekp(start);
  writeHeader();
  stream.seekp(end);
  return stream.good() && std::find(sizes.begin(), sizes.end(), 0) == sizes.end();
}
}
