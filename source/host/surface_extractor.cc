// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/host/cell_volume.h>
#include <mortar_contact/host/surface_extractor.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <deal.II/fe/fe.h>

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>

namespace MortarContact
{
  namespace
  {
    /// Distance of reference points below which they are the same.
    constexpr double same_point = 1e-10;

    /// A vertex of the linear sub-facets of a face: shape functions of the cell
    /// and their weights; its own node first.
    using VertexRow = std::vector<std::pair<unsigned int, double>>;

    /// The sub-facets of one face of a reference cell.
    struct FacePattern
    {
      std::vector<VertexRow>                 vertices;
      std::vector<std::vector<unsigned int>> facets; ///< Cyclic.
    };

    /// Corners of a face (vertices of the cell, that is, its first shape
    /// functions) in cyclic order.
    template <int dim>
    std::vector<unsigned int>
    cyclic_corners(const typename DoFHandler<dim>::active_cell_iterator &cell,
                   const FiniteElement<dim>                             &scalar,
                   const unsigned int                                    face)
    {
      std::vector<unsigned int> corners;
      for (const unsigned int v : cell->vertex_indices())
        for (const unsigned int w : cell->face(face)->vertex_indices())
          if (cell->vertex_index(v) == cell->face(face)->vertex_index(w))
            corners.push_back(v);
      if (corners.size() == 4)
        {
          // the corner farthest from the first one lies opposite
          const auto distance = [&](const unsigned int k) {
            return scalar.unit_support_point(k).distance(
              scalar.unit_support_point(corners[0]));
          };
          const auto opposite =
            std::max_element(corners.begin(),
                             corners.end(),
                             [&](const auto a, const auto b) {
                               return distance(a) < distance(b);
                             });
          std::iter_swap(opposite, corners.begin() + 2);
        }
      return corners;
    }

    template <int dim>
    FacePattern
    make_pattern(const FiniteElement<dim>        &scalar,
                 const std::vector<unsigned int> &corners)
    {
      const unsigned int n = corners.size();

      FacePattern pattern;
      for (const unsigned int c : corners)
        pattern.vertices.push_back({{c, 1.}});
      std::vector<unsigned int> all(n);
      for (unsigned int a = 0; a < n; ++a)
        all[a] = a;
      if (scalar.degree == 1)
        {
          pattern.facets = {all};
          return pattern;
        }

      AssertThrow(scalar.degree == 2,
                  ExcMessage(
                    "Contact surfaces need elements of degree 1 or 2; found " +
                    scalar.get_name() + "."));
      const auto node_at = [&](const Point<dim> &p) {
        for (unsigned int k = 0; k < scalar.n_dofs_per_cell(); ++k)
          if (scalar.unit_support_point(k).distance(p) < same_point)
            return k;
        AssertThrow(false,
                    ExcMessage("Contact surfaces need a Lagrange element; " +
                               scalar.get_name() +
                               " has no node in the middle of an edge."));
        return numbers::invalid_unsigned_int;
      };

      const unsigned int n_edges = (dim == 2) ? 1 : n;
      for (unsigned int a = 0; a < n_edges; ++a)
        {
          const unsigned int c = corners[a], d = corners[(a + 1) % n];
          const Point<dim>   middle =
            scalar.unit_support_point(c) +
            0.5 * (scalar.unit_support_point(d) - scalar.unit_support_point(c));
          pattern.vertices.push_back(
            {{node_at(middle), 4. / 3.}, {c, -1. / 6.}, {d, -1. / 6.}});
        }
      if (dim == 2)
        pattern.facets = {{0, 2}, {2, 1}};
      else if (n == 3)
        pattern.facets = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
      else
        {
          // the tensor product of the rule for edges
          const Point<dim> middle =
            scalar.unit_support_point(corners[0]) +
            0.5 * (scalar.unit_support_point(corners[2]) -
                   scalar.unit_support_point(corners[0]));
          VertexRow row = {{node_at(middle), 16. / 9.}};
          for (unsigned int a = 0; a < 4; ++a)
            {
              row.emplace_back(pattern.vertices[4 + a].front().first, -2. / 9.);
              row.emplace_back(corners[a], 1. / 36.);
            }
          pattern.vertices.push_back(row);
          pattern.facets = {{0, 4, 8, 7},
                            {4, 1, 5, 8},
                            {8, 5, 2, 6},
                            {7, 8, 6, 3}};
        }
      return pattern;
    }
  } // namespace


  template <int dim>
  std::vector<SurfaceFacet<dim>>
  extract_surface(const DoFHandler<dim>    &dof_handler,
                  const Mapping<dim>       &mapping,
                  const FaceSelection      &selection,
                  const ModulusOfCell<dim> &modulus_of_cell,
                  const std::string        &part,
                  const DoFNumbering       &numbering,
                  const unsigned int        first_component,
                  const MPI_Comm            communicator)
  {
    const auto is_selected = [&](const auto &cell, const unsigned int f) {
      return cell->face(f)->at_boundary() &&
             (selection.boundaries.empty() ||
              selection.boundaries.count(cell->face(f)->boundary_id()) > 0) &&
             (selection.materials.empty() ||
              selection.materials.count(cell->material_id()) > 0);
    };

    std::map<std::pair<unsigned int, unsigned int>, FacePattern> patterns;
    std::vector<SurfaceFacet<dim>>                               facets;
    std::vector<types::global_dof_index>                         dofs;
    double     shortest_edge = std::numeric_limits<double>::max();
    const auto extract       = [&](const auto &cell) {
      for (unsigned int e = 0; e < cell->n_lines(); ++e)
        shortest_edge = std::min(shortest_edge, cell->line(e)->diameter());
      for (const unsigned int face : cell->face_indices())
        {
          if (!is_selected(cell, face))
            continue;

          const FiniteElement<dim> &fe = cell->get_fe();
          AssertThrow(first_component + dim <= fe.n_components(),
                      ExcMessage("The displacements of '" + part +
                                 "' are the components " +
                                 std::to_string(first_component) + " to " +
                                 std::to_string(first_component + dim - 1) +
                                 ", but its element " + fe.get_name() +
                                 " has " + std::to_string(fe.n_components()) +
                                 "."));
          const FiniteElement<dim> &scalar =
            fe.base_element(fe.component_to_base_index(first_component).first);
          const auto key     = std::make_pair(cell->active_fe_index(), face);
          auto       pattern = patterns.find(key);
          if (pattern == patterns.end())
            pattern =
              patterns
                .emplace(key,
                         make_pattern(scalar,
                                      cyclic_corners<dim>(cell, scalar, face)))
                .first;

          dofs.resize(fe.n_dofs_per_cell());
          cell->get_dof_indices(dofs);

          SurfaceFacet<dim> common;
          common.label   = {part, cell->global_active_cell_index()};
          common.face    = face;
          common.modulus = modulus_of_cell(cell);
          AssertThrow(common.modulus > 0.,
                      ExcMessage("The contact modulus of cell " +
                                 std::to_string(common.label.cell) + " of '" +
                                 part + "' is " +
                                 std::to_string(common.modulus) +
                                 "; expected a positive number."));
          double face_area = 0.;

          std::vector<SurfaceFacet<dim>> of_face;
          for (const auto &corners : pattern->second.facets)
            {
              SurfaceFacet<dim> facet = common;
              facet.subfacet          = of_face.size();
              facet.n_vertices        = corners.size();
              Facet<dim> reference;
              reference.n_vertices = corners.size();
              for (unsigned int a = 0; a < corners.size(); ++a)
                {
                  SurfaceVertex<dim> &v = facet.vertices[a];
                  for (const auto &[k, weight] :
                       pattern->second.vertices[corners[a]])
                    {
                      typename SurfaceVertex<dim>::Entry entry;
                      entry.weight = weight;
                      for (unsigned int i = 0; i < dim; ++i)
                        entry.dofs[i] = numbering(
                          dofs[fe.component_to_system_index(first_component + i,
                                                            k)]);
                      v.row.push_back(entry);
                      v.reference +=
                        weight * mapping.transform_unit_to_real_cell(
                                   cell, scalar.unit_support_point(k));
                    }
                  reference.x[a] = v.reference;
                }

              // outward
              const Tensor<1, dim> w = centre_normal(reference);
              if (w * (centre(reference) - cell->center()) < 0.)
                std::reverse(facet.vertices.begin(),
                             facet.vertices.begin() + facet.n_vertices);
              face_area += area(reference);
              of_face.push_back(facet);
            }

          // height of the cell over the face: V/A, for simplices dim V/A
          const bool is_simplex =
            cell->reference_cell().n_vertices() == dim + 1;
          const double length =
            (is_simplex ? dim : 1.) * cell_volume(cell) / face_area;
          AssertThrow(length > 0.,
                      ExcMessage("Cell " + std::to_string(common.label.cell) +
                                 " of '" + part +
                                 "' has no positive volume: the mesh is "
                                       "inside out or degenerate there."));
          for (auto &facet : of_face)
            {
              facet.length = length;
              facets.push_back(facet);
            }
        }
    };

    // What is wrong on one rank all ranks must say: none may be left waiting.
    std::string failure;
    try
      {
        for (const auto &cell : dof_handler.active_cell_iterators())
          if (cell->is_locally_owned())
            extract(cell);
      }
    catch (const ExceptionBase &e)
      {
        std::ostringstream info;
        e.print_info(info);
        failure = Utilities::trim(info.str());
      }
    for (const std::string &f :
         Utilities::MPI::all_gather(communicator, failure))
      AssertThrow(f.empty(), ExcMessage(f));

    shortest_edge = Utilities::MPI::min(shortest_edge, communicator);
    for (auto &facet : facets)
      facet.shortest_edge = shortest_edge;
    return facets;
  }


  template std::vector<SurfaceFacet<2>>
  extract_surface<2>(const DoFHandler<2> &,
                     const Mapping<2> &,
                     const FaceSelection &,
                     const ModulusOfCell<2> &,
                     const std::string &,
                     const DoFNumbering &,
                     const unsigned int,
                     const MPI_Comm);
  template std::vector<SurfaceFacet<3>>
  extract_surface<3>(const DoFHandler<3> &,
                     const Mapping<3> &,
                     const FaceSelection &,
                     const ModulusOfCell<3> &,
                     const std::string &,
                     const DoFNumbering &,
                     const unsigned int,
                     const MPI_Comm);
} // namespace MortarContact
