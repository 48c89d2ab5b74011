// SPDX-License-Identifier: LGPL-2.1-or-later
#include "stop_signal.h"

#include <csignal>

namespace Structure
{
  namespace
  {
    volatile std::sig_atomic_t requested = 0;

    extern "C" void
    request_stop(int)
    {
      requested = 1;
    }
  } // namespace


  void
  catch_stop_signals()
  {
    std::signal(SIGTERM, request_stop);
    std::signal(SIGUSR1, request_stop);
  }


  bool
  stop_is_requested(const MPI_Comm communicator)
  {
    return dealii::Utilities::MPI::max(requested != 0 ? 1 : 0, communicator) !=
           0;
  }
} // namespace Structure
