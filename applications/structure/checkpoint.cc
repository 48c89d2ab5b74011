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
    const std::string title = "MortarContact checkpoint 3";

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
  write_state(const std::string &title,
              const std::string &text,
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
        std::ofstream out(fresh, std::ios::binary);
        out << title << '\n' << sum_of(text) << '\n' << text;
        out.close();
        ok = !out.fail();
        if (ok)
          fs::rename(fresh, file, error);
        ok = ok && !error;
      }
    AssertThrow(Utilities::MPI::broadcast(communicator, ok),
                ExcMessage("The checkpoint '" + fresh +
                           "' cannot be written (disk full?). The previous one "
                           "is still valid."));
  }


  std::string
  read_state(const std::string &title,
             const std::string &directory,
             const MPI_Comm     communicator)
  {
    const std::string file = file_in(directory);
    std::string       failure, text;
    std::ifstream     in(file, std::ios::binary);
    std::string       head(title.size() + 1, ' ');
    std::uint64_t     sum = 0;
    if (!in)
      failure = "there is no such file";
    else if (!in.read(head.data(), head.size()) || head != title + '\n')
      failure = "it was written by another version, or is no checkpoint";
    else if (!(in >> sum) || in.get() != '\n')
      failure = "it is damaged or truncated";
    else
      {
        std::ostringstream rest;
        rest << in.rdbuf();
        text = rest.str();
        if (sum_of(text) != sum)
          failure = "it is damaged or truncated";
      }
    for (const auto &f : Utilities::MPI::all_gather(communicator, failure))
      if (!f.empty())
        failure = f;
    AssertThrow(failure.empty(),
                ExcMessage("The checkpoint '" + file +
                           "' cannot be continued: " + failure + "."));
    return text;
  }


  void
  write_checkpoint(const Checkpoint  &checkpoint,
                   const std::string &directory,
                   const MPI_Comm     communicator)
  {
    std::ostringstream stream;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      boost::archive::binary_oarchive(stream) << checkpoint;
    write_state(title, stream.str(), directory, communicator);
  }


  Checkpoint
  read_checkpoint(const std::string &directory, const MPI_Comm communicator)
  {
    std::istringstream stream(read_state(title, directory, communicator));
    Checkpoint         checkpoint;
    try
      {
        boost::archive::binary_iarchive archive(stream);
        archive >> checkpoint;
      }
    catch (const std::exception &)
      {
        AssertThrow(false,
                    ExcMessage("The checkpoint '" + file_in(directory) +
                               "' cannot be continued: it was written by "
                               "another version."));
      }
    return checkpoint;
  }
} // namespace Structure
