// SPDX-License-Identifier: LGPL-2.1-or-later
#include "output.h"

#include <deal.II/base/utilities.h>

#include <deal.II/numerics/data_out.h>

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>

namespace Structure
{
  namespace
  {
    /// Yellow for what needs attention, cyan for advice, as terminals are told.
    const char *
    colour_of(const std::string &text)
    {
      for (const char *word : {"WARNING", "rejected", "No convergence"})
        if (text.find(word) != std::string::npos)
          return "\033[33m";
      for (const char *word : {"ACCURACY:", "SPEED:", "NOTE:"})
        if (text.find(word) != std::string::npos)
          return "\033[36m";
      return "";
    }

    /// STL as text. A point is the same text wherever it stands.
    template <int dim>
    std::string
    stl_of(const std::vector<std::array<Point<dim>, 3>> &triangles,
           const std::string                            &name)
    {
      std::ostringstream out;
      out.precision(12);
      out << "solid " << name << '\n';
      for (const auto &triangle : triangles)
        {
          out << "facet normal 0 0 0\nouter loop\n";
          for (const Point<dim> &x : triangle)
            out << "vertex " << x << '\n';
          out << "endloop\nendfacet\n";
        }
      out << "endsolid " << name << '\n';
      return out.str();
    }
  } // namespace


  Log::Log(const MPI_Comm communicator, const bool quiet)
    : is_root(Utilities::MPI::this_mpi_process(communicator) == 0)
    , quiet(quiet)
    , has_colour(isatty(STDOUT_FILENO) == 1 &&
                 std::getenv("NO_COLOR") == nullptr)
  {}


  void
  Log::open(const std::string &name, const bool append)
  {
    if (is_root)
      file.open(name, append ? std::ios::app : std::ios::trunc);
  }


  void
  Log::line(const std::string &text)
  {
    if (!is_root)
      return;
    if (quiet && text.rfind("No convergence", 0) == 0)
      std::cerr << text << std::endl;
    if (!quiet)
      {
        const char *colour = has_colour ? colour_of(text) : "";
        std::cout << colour << text << (*colour ? "\033[0m" : "") << std::endl;
      }
    if (file)
      file << text << std::endl;
  }


  template <int dim>
  Output<dim>::Output(const std::string &directory,
                      const double       surface_offset,
                      const MPI_Comm     communicator)
    : directory(directory)
    , surface_offset(surface_offset)
    , communicator(communicator)
  {}


  template <int dim>
  void
  Output<dim>::start(const std::string &parameters)
  {
    namespace fs = std::filesystem;
    std::string failure;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          std::error_code error;
          fs::create_directories(directory, error);
          if (!fs::is_directory(directory))
            failure = "this folder cannot be made";
          else
            {
              for (const auto &entry : fs::directory_iterator(directory))
                {
                  const std::string name = entry.path().filename();
                  const bool        ours =
                    name == "history.csv" || name == "summary.json" ||
                    name == "solution.pvd" || name == "contact.pvd" ||
                    (name.rfind("surface-", 0) == 0 &&
                     entry.path().extension() == ".stl") ||
                    ((name.rfind("solution-", 0) == 0 ||
                      name.rfind("contact-", 0) == 0) &&
                     entry.path().extension() == ".vtu");
                  if (ours)
                    fs::remove(entry.path());
                }
              fs::remove_all(directory + "/checkpoint");
            }
        }
      catch (const fs::filesystem_error &e)
        {
          failure = "nothing can be written there (" + e.code().message() + ")";
        }
    failure = Utilities::MPI::broadcast(communicator, failure);
    AssertThrow(failure.empty(),
                ExcMessage("'Output/Directory' is '" + directory + "'; " +
                           failure + "."));
    text_file("parameters.prm", parameters);
  }


  template <int dim>
  void
  Output<dim>::resume(const double time)
  {
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    const double last = time * (1. + 1e-12);
    solution_files    = read_collection("solution.pvd", last);
    contact_files     = read_collection("contact.pvd", last);

    std::ifstream in(directory + "/history.csv");
    std::string   row, kept;
    // columns: step, time, ...
    while (std::getline(in, row))
      {
        const std::size_t comma = row.find(',');
        if (comma == std::string::npos)
          continue;
        const std::string second =
          row.substr(comma + 1, row.find(',', comma + 1));
        if (kept.empty() || std::atof(second.c_str()) <= last)
          kept += row + "\n";
      }
    in.close();
    has_history = !kept.empty();
    text_file("history.csv", kept);
  }


  template <int dim>
  void
  Output<dim>::write_collection(const std::string          &name,
                                const std::vector<DataSet> &sets) const
  {
    std::ostringstream out;
    out.precision(16);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "
           "version=\"0.1\">\n<Collection>\n";
    for (const DataSet &set : sets)
      out << "<DataSet timestep=\"" << set.time << "\" group=\"\" part=\""
          << set.part << "\" file=\"" << set.file << "\"/>\n";
    out << "</Collection>\n</VTKFile>\n";
    text_file(name, out.str());
  }


  template <int dim>
  std::vector<typename Output<dim>::DataSet>
  Output<dim>::read_collection(const std::string &name,
                               const double       last_time) const
  {
    std::vector<DataSet> sets;
    std::ifstream        in(directory + "/" + name);
    std::string          line;
    while (std::getline(in, line))
      {
        DataSet set;
        char    file[512];
        if (std::sscanf(line.c_str(),
                        "<DataSet timestep=\"%lf\" group=\"\" part=\"%u\" "
                        "file=\"%511[^\"]",
                        &set.time,
                        &set.part,
                        file) == 3 &&
            set.time <= last_time)
          {
            set.file = file;
            sets.push_back(set);
          }
      }
    return sets;
  }


  template <int dim>
  void
  Output<dim>::add_to_solution(const double       time,
                               const unsigned int part,
                               const std::string &file)
  {
    solution_files.push_back({time, part, file});
    write_collection("solution.pvd", solution_files);
  }


  template <int dim>
  void
  Output<dim>::text_file(const std::string &name,
                         const std::string &content) const
  {
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    const std::string file = directory + "/" + name;
    {
      std::ofstream out(file + ".new");
      out << content;
      out.close();
      AssertThrow(out,
                  ExcMessage("The file '" + file + "' cannot be written."));
    }
    std::filesystem::rename(file + ".new", file);
  }


  template <int dim>
  void
  Output<dim>::history(const std::vector<std::pair<std::string, double>> &row)
  {
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    std::ofstream out(directory + "/history.csv",
                      has_history ? std::ios::app : std::ios::trunc);
    if (!has_history)
      for (std::size_t i = 0; i < row.size(); ++i)
        out << row[i].first << (i + 1 < row.size() ? "," : "\n");
    out.precision(16);
    for (std::size_t i = 0; i < row.size(); ++i)
      out << row[i].second << (i + 1 < row.size() ? "," : "\n");
    out.close();
    AssertThrow(out,
                ExcMessage("The file '" + directory +
                           "/history.csv' cannot be written."));
    has_history = true;
  }


  template <int dim>
  void
  Output<dim>::fields(const Model<dim>  &model,
                      const Vector_t    &u,
                      const double       time,
                      const unsigned int step)
  {
    const auto file_name = [&](const std::string &kind,
                               std::string        of,
                               const std::string &extension = ".vtu") {
      for (char &c : of)
        if (!std::isalnum(static_cast<unsigned char>(c)))
          c = '_';
      return kind + "-" + of + "-" + Utilities::int_to_string(step, 4) +
             extension;
    };
    const Vector_t                       ghosted = model.ghosted(u);
    Vector<double>                       values;
    std::vector<types::global_dof_index> dofs;
    unsigned int                         part = 0;
    for (const auto &body : model.bodies)
      {
        const std::string name = file_name("solution", body->name);
        body->write(
          [&](const unsigned int cell) -> const Vector<double> & {
            model.cell_values(*body, cell, ghosted, values, dofs);
            return values;
          },
          directory + "/" + name,
          communicator);
        solution_files.push_back({time, part++, name});
      }
    if (surface_offset >= 0.)
      {
        const Vector<double> all(u);
        for (const auto &body : model.bodies)
          {
            const auto surface = body->outer_surface(all, surface_offset);
            if (!surface.empty())
              text_file(file_name("surface", body->name, ".stl"),
                        stl_of(surface, body->name));
          }
      }
    part = 0;
    for (const auto &interface : model.interfaces)
      {
        const std::string name = file_name("contact", interface->name);
        MortarContact::write_contact_vtu(*interface,
                                         directory + "/" + name,
                                         communicator);
        contact_files.push_back({time, part++, name});
      }
    write_collection("solution.pvd", solution_files);
    write_collection("contact.pvd", contact_files);
  }


  template class Output<2>;
  template class Output<3>;
} // namespace Structure
