// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/host/surface_extractor.h>

#include <deal.II/fe/fe.h>

#include <algorithm>

namespace MortarContact
{
  template <int dim>
  std::vector<SurfaceFacet<dim>>
  extract_shell(const DoFHandler<dim - 1, dim> &dof_handler,
                const FaceSelection            &selection,
                const ShellSkin<dim>           &skin,
                const std::string              &part,
                const DoFNumbering             &numbering)
  {
    AssertThrow(skin.thickness > 0. && skin.modulus > 0.,
                ExcMessage("The shell '" + part + "' has thickness " +
                           std::to_string(skin.thickness) +
                           " and contact modulus " +
                           std::to_string(skin.modulus) +
                           "; expected positive numbers."));
    AssertThrow(dof_handler.get_fe().degree == 1,
                ExcMessage("Contact surfaces of shells need elements of degree "
                           "1; found " +
                           dof_handler.get_fe().get_name() + "."));
    const auto thickness_at = [&](const unsigned int vertex) {
      return skin.thickness_at ? skin.thickness_at(vertex) : skin.thickness;
    };

    // x = X +- (t/2) D + v +- t/(2 s) q. The first entry tells vertices apart:
    // v for the top, q for the bottom.
    const auto vertex_of =
      [&](const auto &cell, const unsigned int v, const bool is_top) {
        const double side =
          (is_top ? 0.5 : -0.5) * thickness_at(cell->vertex_index(v));
        SurfaceVertex<dim>   vertex;
        const Tensor<1, dim> place = cell->vertex(v);
        vertex.reference = place + side * skin.director(cell->vertex_index(v));
        typename SurfaceVertex<dim>::Entry of_v, of_q;
        of_v.weight = 1.;
        of_q.weight = side / skin.director_scale;
        for (unsigned int i = 0; i < dim; ++i)
          {
            of_v.dofs[i] =
              numbering(cell->vertex_dof_index(v, skin.first_component + i));
            of_q.dofs[i] = numbering(
              cell->vertex_dof_index(v, skin.first_director_component + i));
          }
        vertex.row = is_top ? std::vector<decltype(of_v)>{of_v, of_q} :
                              std::vector<decltype(of_v)>{of_q, of_v};
        return vertex;
      };

    std::vector<SurfaceFacet<dim>> facets;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        if (!cell->is_locally_owned() ||
            (!selection.materials.empty() &&
             selection.materials.count(cell->material_id()) == 0))
          continue;
        SurfaceFacet<dim> common;
        common.label   = {part, cell->global_active_cell_index()};
        common.modulus = skin.modulus;
        for (const unsigned int v : cell->vertex_indices())
          common.length +=
            thickness_at(cell->vertex_index(v)) / cell->n_vertices();
        common.shortest_edge = common.length;

        // counterclockwise about the cell's own normal
        std::vector<unsigned int> cyclic;
        for (const unsigned int v : cell->vertex_indices())
          cyclic.push_back(v);
        if (cyclic.size() == 4)
          std::swap(cyclic[2], cyclic[3]);
        const bool is_up = skin.orientation(cell->active_cell_index()) > 0;
        for (const bool is_top : {true, false})
          {
            if (!(is_top ? selection.top : selection.bottom))
              continue;
            SurfaceFacet<dim> facet = common;
            facet.face              = is_top ? 0 : 1;
            facet.n_vertices        = cyclic.size();
            for (unsigned int a = 0; a < cyclic.size(); ++a)
              facet.vertices[a] = vertex_of(cell, cyclic[a], is_top);
            // normals of lines point to the right of their direction
            if ((is_top == is_up) != (dim == 3))
              std::reverse(facet.vertices.begin(),
                           facet.vertices.begin() + facet.n_vertices);
            facets.push_back(facet);
          }
        if (!selection.edges)
          continue;
        for (const unsigned int f : cell->face_indices())
          {
            if (!cell->face(f)->at_boundary() ||
                (!selection.boundaries.empty() &&
                 selection.boundaries.count(cell->face(f)->boundary_id()) == 0))
              continue;
            std::vector<unsigned int> ends;
            for (const unsigned int v : cell->vertex_indices())
              for (const unsigned int w : cell->face(f)->vertex_indices())
                if (cell->vertex_index(v) == cell->face(f)->vertex_index(w))
                  ends.push_back(v);
            SurfaceFacet<dim> facet = common;
            facet.face              = 2 + f;
            for (const unsigned int v : ends)
              facet.vertices[facet.n_vertices++] = vertex_of(cell, v, false);
            for (unsigned int k = ends.size(); k-- > 0;)
              facet.vertices[facet.n_vertices++] =
                vertex_of(cell, ends[k], true);
            Facet<dim> reference;
            reference.n_vertices = facet.n_vertices;
            for (unsigned int a = 0; a < facet.n_vertices; ++a)
              reference.x[a] = facet.vertices[a].reference;
            if (centre_normal(reference) *
                  (centre(reference) - cell->center()) <
                0.)
              std::reverse(facet.vertices.begin(),
                           facet.vertices.begin() + facet.n_vertices);
            facets.push_back(facet);
          }
      }
    return facets;
  }


  template std::vector<SurfaceFacet<2>>
  extract_shell<2>(const DoFHandler<1, 2> &,
                   const FaceSelection &,
                   const ShellSkin<2> &,
                   const std::string &,
                   const DoFNumbering &);
  template std::vector<SurfaceFacet<3>>
  extract_shell<3>(const DoFHandler<2, 3> &,
                   const FaceSelection &,
                   const ShellSkin<3> &,
                   const std::string &,
                   const DoFNumbering &);
} // namespace MortarContact
