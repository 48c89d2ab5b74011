// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_surface_reader_h
#define mortar_contact_applications_surface_reader_h

#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace Structure
{
  using namespace dealii;

  /**
   * Read a surface mesh of facets: STL (text or binary), gmsh .msh, Abaqus
   * .inp, VTK .vtk. Vertices of STL facets at the same place are joined.
   * @throw ExcMessage if the file is none of them.
   */
  template <int dim>
  void
  read_surface(const std::string                      &file,
               std::vector<Tensor<1, dim>>            &vertices,
               std::vector<std::vector<unsigned int>> &facets);
} // namespace Structure

#endif
