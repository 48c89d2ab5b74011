// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz.h"

#include <deal.II/base/mpi.h>

#include <structure/checkpoint.h>

#include <filesystem>

extern "C" int
LLVMFuzzerInitialize(int *argc, char ***argv)
{
  static dealii::Utilities::MPI::MPI_InitFinalize mpi(*argc, *argv, 1);
  return 0;
}

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  const std::string folder = Fuzz::folder();
  std::filesystem::create_directories(folder + "/checkpoint");
  (void)Fuzz::file_of(data, size, "checkpoint/state");
  Fuzz::read_or_refuse(
    [&]() { (void)Structure::read_checkpoint(folder, MPI_COMM_SELF); });
  return 0;
}
