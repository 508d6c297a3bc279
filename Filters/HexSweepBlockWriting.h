// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The values of an array as compressed blocks in base64, as VTK's XML formats have them.
 * Private to the module.
 */
#ifndef HexSweepBlockWriting_h
#define HexSweepBlockWriting_h

#include <cstddef>
#include <iosfwd>

class vtkDataCompressor;

namespace hexsweep
{
/// Values that lie one after the other in memory.
struct BlockValues
{
  const unsigned char* data;
  std::size_t count;
  std::size_t size;     ///< bytes of one
  bool halved;          ///< integers of 64 bits that are written as ones of 32
  std::size_t perBlock; ///< values in a block; the last one has what is left

  std::size_t writtenSize() const { return this->halved ? this->size / 2 : this->size; }
  std::size_t blocks() const { return (this->count + this->perBlock - 1) / this->perBlock; }
};

/**
 * Writes the sizes of the blocks and the blocks, on the threads of vtkSMPTools: the same bytes with
 * any number of them. Holds a few megabytes at a time.
 *
 * @param stream     can be positioned: sizes are known when their blocks are written.
 * @param headerBits 32 or 64: of the sizes.
 * @return whether all went well.
 */
bool writeBlocks(
  const BlockValues& values, vtkDataCompressor* compressor, int headerBits, std::ostream& stream);
}

#endif
