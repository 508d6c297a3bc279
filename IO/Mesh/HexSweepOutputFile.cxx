// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepOutputFile.h"

#include <vtksys/SystemTools.hxx>

#include <cerrno>
#include <charconv>
#include <cstring>

namespace hexsweep
{
namespace
{
constexpr std::size_t BufferSize = 1 << 20;
/// More than any number has as text.
constexpr std::size_t LongestNumber = 32;
}

OutputFile::OutputFile(const std::string& name)
  : Name(name)
  , Buffer(BufferSize)
  , File(vtksys::SystemTools::Fopen(name, "wb"))
{
  if (!this->File)
  {
    this->fail();
  }
}

OutputFile::~OutputFile()
{
  if (this->File)
  {
    std::fclose(this->File);
    vtksys::SystemTools::RemoveFile(this->Name);
  }
}

OutputFile& OutputFile::operator<<(std::string_view text)
{
  if (text.size() > this->Buffer.size())
  {
    this->flush();
    this->Buffer.resize(text.size());
  }
  std::memcpy(this->room(text.size()), text.data(), text.size());
  this->Used += text.size();
  return *this;
}

OutputFile& OutputFile::operator<<(char character)
{
  return *this << std::string_view(&character, 1);
}

OutputFile& OutputFile::operator<<(int number)
{
  return this->number(number);
}

OutputFile& OutputFile::operator<<(long number)
{
  return this->number(number);
}

OutputFile& OutputFile::operator<<(long long number)
{
  return this->number(number);
}

OutputFile& OutputFile::operator<<(std::size_t number)
{
  return this->number(number);
}

OutputFile& OutputFile::operator<<(double number)
{
  return this->number(number);
}

template <typename Number>
OutputFile& OutputFile::number(Number number)
{
  char* begin = this->room(LongestNumber);
  const std::to_chars_result result = std::to_chars(begin, begin + LongestNumber, number);
  this->Used += static_cast<std::size_t>(result.ptr - begin);
  return *this;
}

void OutputFile::shortened(double number, std::size_t longest)
{
  char* begin = this->room(LongestNumber);
  std::to_chars_result result = std::to_chars(begin, begin + LongestNumber, number);
  for (int digits = 16; digits > 0 && result.ptr - begin > static_cast<long>(longest); --digits)
  {
    result =
      std::to_chars(begin, begin + LongestNumber, number, std::chars_format::general, digits);
  }
  this->Used += static_cast<std::size_t>(result.ptr - begin);
}

char* OutputFile::room(std::size_t characters)
{
  if (this->Buffer.size() - this->Used < characters)
  {
    this->flush();
  }
  return this->Buffer.data() + this->Used;
}

void OutputFile::close()
{
  this->flush();
  std::FILE* file = this->File;
  this->File = nullptr;
  if (std::fclose(file) != 0)
  {
    const int error = errno;
    vtksys::SystemTools::RemoveFile(this->Name);
    errno = error;
    this->fail();
  }
}

void OutputFile::flush()
{
  if (std::fwrite(this->Buffer.data(), 1, this->Used, this->File) != this->Used)
  {
    this->fail();
  }
  this->Used = 0;
}

void OutputFile::fail() const
{
  throw WriteFailure(this->Name + " cannot be written: " + std::strerror(errno) + ".");
}
}
