// SPDX-License-Identifier: LGPL-2.1-or-later
#include "stop_signal.h"

#include <signal.h>

namespace Structure
{
  namespace
  {
    volatile sig_atomic_t requested = 0;

    extern "C" void
    request_stop(int)
    {
      requested = 1;
    }
  } // namespace


  void
  catch_stop_signals()
  {
    struct sigaction action = {};
    action.sa_handler       = request_stop;
    // the second one ends the program, as ever
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    sigaction(SIGUSR1, &action, nullptr);
  }


  bool
  stop_is_requested(const MPI_Comm communicator)
  {
    return dealii::Utilities::MPI::max(requested != 0 ? 1 : 0, communicator) !=
           0;
  }
} // namespace Structure
