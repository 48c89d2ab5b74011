// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_output_h
#define mortar_contact_structure_output_h

#include "model.h"

#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace Structure
{
  /// Progress for people: to the terminal and to run.log, on rank 0.
  class Log
  {
  public:
    explicit Log(const MPI_Comm communicator, const bool quiet);

    /// Also write to this file from now on.
    void
    open(const std::string &file, const bool append);

    void
    line(const std::string &text);

    const bool is_root;

  private:
    const bool    quiet;
    const bool    has_colour; ///< The terminal takes them.
    std::ofstream file;
  };

  /**
   * The output folder: VTU files of the bodies and of the contact surfaces with
   * their collections (solution.pvd, contact.pvd), history.csv, parameters.prm,
   * summary.json. A second run into the same folder removes what this class
   * wrote there before, so that runs never mix.
   */
  template <int dim>
  class Output
  {
  public:
    /// @param surface_offset Of the surfaces of shells [m]; negative: none.
    Output(const std::string &directory,
           const double       surface_offset,
           const MPI_Comm     communicator);

    /// Prepare the folder for a new run: remove the files of an earlier one.
    void
    start(const std::string &parameters);

    /// Prepare the folder for going on after @p time: forget what was written
    /// for later times.
    void
    resume(const double time);

    /// Append a row to history.csv; the first row writes the names.
    void
    history(const std::vector<std::pair<std::string, double>> &row);

    /// Write the present state of all bodies and interfaces.
    void
    fields(const Model<dim>  &model,
           const Vector_t    &u,
           const double       time,
           const unsigned int step);

    /// Make @p file, which the caller has written to the folder, a part of
    /// solution.pvd.
    void
    add_to_solution(const double       time,
                    const unsigned int part,
                    const std::string &file);

    /// Write a text file on rank 0, whole or not at all.
    void
    text_file(const std::string &name, const std::string &content) const;

    const std::string directory;

  private:
    const double   surface_offset;
    const MPI_Comm communicator;
    /// A line of a collection.
    struct DataSet
    {
      double       time;
      unsigned int part;
      std::string  file;
    };

    void
    write_collection(const std::string          &name,
                     const std::vector<DataSet> &sets) const;

    std::vector<DataSet>
    read_collection(const std::string &name, const double last_time) const;

    std::vector<DataSet> solution_files, contact_files;
    bool                 has_history = false;
  };
} // namespace Structure

#endif
