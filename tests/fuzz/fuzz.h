// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_tests_fuzz_h
#define mortar_contact_tests_fuzz_h

// Targets for libFuzzer, see scripts/fuzz.sh: readers get any bytes, and read
// them or refuse them with an ExcMessage. Whatever else comes out of them ends
// the fuzzer.

#include <deal.II/base/exceptions.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>

namespace Fuzz
{
  /// Where the files go.
  inline std::string
  folder()
  {
    const char *given = std::getenv("FUZZ_FOLDER");
    return given ? given : ".";
  }

  /// The bytes as a file.
  inline std::string
  file_of(const std::uint8_t *data,
          const std::size_t   size,
          const std::string  &name)
  {
    const std::string file = folder() + "/" + name;
    std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char *>(data), size);
    return file;
  }

  template <class Function>
  void
  read_or_refuse(const Function &read)
  {
    try
      {
        read();
      }
    catch (const dealii::ExcMessage &)
      {}
  }
} // namespace Fuzz

#endif
