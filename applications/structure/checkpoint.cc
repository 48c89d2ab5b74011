// SPDX-License-Identifier: LGPL-2.1-or-later
#include "checkpoint.h"

#include <deal.II/base/exceptions.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace Structure
{
  using namespace dealii;

  namespace
  {
    const std::string magic = "MortarContact checkpoint 3\n";

    std::string
    file_in(const std::string &directory)
    {
      return directory + "/checkpoint/state";
    }

    /// FNV-1a: finds what a broken disk or copy has changed.
    std::uint64_t
    sum_of(const std::string &text)
    {
      std::uint64_t sum = 14695981039346656037u;
      for (const char c : text)
        sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211u;
      return sum;
    }
  } // namespace


  void
  write_checkpoint(const Checkpoint  &checkpoint,
                   const std::string &directory,
                   const MPI_Comm     communicator)
  {
    namespace fs            = std::filesystem;
    const std::string file  = file_in(directory);
    const std::string fresh = file + ".new";
    bool              ok    = true;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error; // seen below, when nothing can be written
        fs::create_directories(fs::path(file).parent_path(), error);
        try
          {
            std::ostringstream stream;
            boost::archive::binary_oarchive(stream) << checkpoint;
            const std::string text = stream.str();
            std::ofstream     out(fresh, std::ios::binary);
            out << magic << sum_of(text) << '\n' << text;
            out.close();
            ok = !out.fail();
          }
        catch (const std::exception &)
          {
            ok = false;
          }
        if (ok)
          fs::rename(fresh, file, error);
        ok = ok && !error;
      }
    AssertThrow(Utilities::MPI::broadcast(communicator, ok),
                ExcMessage("The checkpoint '" + fresh +
                           "' cannot be written (disk full?). The previous one "
                           "is still valid."));
  }


  Checkpoint
  read_checkpoint(const std::string &directory, const MPI_Comm communicator)
  {
    const std::string file = file_in(directory);
    Checkpoint        checkpoint;
    std::string       failure;
    std::ifstream     in(file, std::ios::binary);
    std::string       head(magic.size(), ' ');
    std::uint64_t     sum = 0;
    if (!in)
      failure = "there is no such file";
    else if (!in.read(head.data(), head.size()) || head != magic)
      failure = "it was written by another version, or is no checkpoint";
    else if (!(in >> sum) || in.get() != '\n')
      failure = "it is damaged or truncated";
    else
      {
        std::ostringstream rest;
        rest << in.rdbuf();
        const std::string text = rest.str();
        if (sum_of(text) != sum)
          failure = "it is damaged or truncated";
        else
          try
            {
              std::istringstream              stream(text);
              boost::archive::binary_iarchive archive(stream);
              archive >> checkpoint;
            }
          catch (const std::exception &)
            {
              failure = "it was written by another version";
            }
      }
    for (const auto &f : Utilities::MPI::all_gather(communicator, failure))
      if (!f.empty())
        failure = f;
    AssertThrow(failure.empty(),
                ExcMessage("The checkpoint '" + file +
                           "' cannot be continued: " + failure + "."));
    return checkpoint;
  }
} // namespace Structure
