// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A file that numbers are written to, fast and checked. Private to the module.
 */
#ifndef HexSweepOutputFile_h
#define HexSweepOutputFile_h

#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace hexsweep
{
/// The file could not be written: the message says why.
class WriteFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/**
 * Numbers are written in the shortest form that reads back as the same number.
 *
 * What is left of a file that was not closed is removed: a part of a mesh must not pass for one.
 * All members throw WriteFailure.
 */
class OutputFile
{
public:
  explicit OutputFile(const std::string& name);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  OutputFile& operator<<(std::string_view text);
  OutputFile& operator<<(char character);
  OutputFile& operator<<(int number);
  OutputFile& operator<<(long number);
  OutputFile& operator<<(long long number);
  OutputFile& operator<<(std::size_t number);
  OutputFile& operator<<(double number);

  /// With as many digits as so many characters take.
  void shortened(double number, std::size_t longest);

  /// As the machine holds it.
  template <typename Number>
  void binary(Number number)
  {
    *this << std::string_view(reinterpret_cast<const char*>(&number), sizeof number);
  }

  void close();

private:
  template <typename Number>
  OutputFile& number(Number number);
  char* room(std::size_t characters);
  void flush();
  [[noreturn]] void fail() const;

  std::string Name;
  std::vector<char>
    Buffer; // before the file: where there is no room for it, there is no file either
  std::FILE* File;
  std::size_t Used = 0;
};
}

#endif
