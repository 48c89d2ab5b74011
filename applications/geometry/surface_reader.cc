// SPDX-License-Identifier: LGPL-2.1-or-later
#include "surface_reader.h"

#include "abaqus_deck.h"

#include <mortar_contact/host/rigid_body.h>

#include <deal.II/base/exceptions.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

namespace Structure
{
  namespace
  {
    using Corner = std::array<float, 3>;

    /// Corners of the triangles of an STL file; empty if it is none.
    std::vector<std::array<Corner, 3>>
    stl_triangles(const std::string &content)
    {
      std::vector<std::array<Corner, 3>> triangles;
      // binary: 80 bytes, a count, 50 bytes per triangle
      if (content.size() >= 84)
        {
          std::uint32_t n = 0;
          std::memcpy(&n, content.data() + 80, 4);
          if (content.size() == 84 + 50 * static_cast<std::size_t>(n))
            {
              triangles.resize(n);
              for (std::size_t i = 0; i < n; ++i)
                for (unsigned int v = 0; v < 3; ++v)
                  std::memcpy(triangles[i][v].data(),
                              content.data() + 84 + 50 * i + 12 * (v + 1),
                              12);
              return triangles;
            }
        }
      std::istringstream  in(content);
      std::string         word;
      std::vector<Corner> corners;
      in >> word;
      if (word != "solid")
        return {};
      while (in >> word)
        if (word == "vertex")
          {
            Corner c;
            if (!(in >> c[0] >> c[1] >> c[2]))
              return {};
            corners.push_back(c);
          }
      if (corners.size() % 3 != 0)
        return {};
      for (std::size_t i = 0; i < corners.size(); i += 3)
        triangles.push_back({{corners[i], corners[i + 1], corners[i + 2]}});
      return triangles;
    }
  } // namespace


  template <int dim>
  void
  read_surface(const std::string                      &file,
               std::vector<Tensor<1, dim>>            &vertices,
               std::vector<std::vector<unsigned int>> &facets)
  {
    std::ifstream in(file, std::ios::binary);
    AssertThrow(in,
                ExcMessage("'File' is '" + file +
                           "'; this file cannot be opened."));
    const std::string ending = file.substr(file.find_last_of('.') + 1);
    vertices.clear();
    facets.clear();
    bool ok = true;
    if (ending == "stl" || ending == "STL")
      {
        std::ostringstream content;
        content << in.rdbuf();
        std::map<Corner, unsigned int> known;
        if (dim == 3)
          for (const auto &triangle : stl_triangles(content.str()))
            {
              std::vector<unsigned int> facet;
              for (const Corner &c : triangle)
                {
                  const auto inserted = known.try_emplace(c, vertices.size());
                  if (inserted.second)
                    {
                      Tensor<1, dim> x;
                      for (unsigned int i = 0; i < dim; ++i)
                        x[i] = c[i];
                      vertices.push_back(x);
                    }
                  facet.push_back(inserted.first->second);
                }
              // slivers without area carry nothing
              if (facet[0] != facet[1] && facet[1] != facet[2] &&
                  facet[0] != facet[2])
                facets.push_back(facet);
            }
      }
    else if (dim == 3 && ending == "inp")
      {
        // the order of the nodes, so the normals, is the file's
        const AbaqusDeck deck = read_abaqus(file, AbaqusKind::shell);
        std::map<unsigned long, unsigned int> vertex_of;
        for (const auto &element : deck.elements)
          {
            std::vector<unsigned int> facet;
            for (const unsigned long node : element.second)
              {
                const auto inserted =
                  vertex_of.try_emplace(node, vertices.size());
                if (inserted.second)
                  {
                    Tensor<1, dim> x;
                    for (unsigned int i = 0; i < dim; ++i)
                      x[i] = deck.nodes.at(node)[i];
                    vertices.push_back(x);
                  }
                // triangles may be quadrilaterals with two equal nodes
                if (std::find(facet.begin(),
                              facet.end(),
                              inserted.first->second) == facet.end())
                  facet.push_back(inserted.first->second);
              }
            if (facet.size() >= 3)
              facets.push_back(facet);
          }
      }
    else
      try
        {
          Triangulation<dim - 1, dim> mesh;
          GridIn<dim - 1, dim>        reader(mesh);
          if (ending == "msh")
            reader.read_msh(in);
          else if (ending == "inp")
            reader.read_abaqus(in);
          else if (ending == "vtk")
            reader.read_vtk(in);
          else
            ok = false;
          if (ok)
            MortarContact::facets_of<dim>(mesh, vertices, facets);
        }
      catch (const std::exception &)
        {
          ok = false;
        }
    AssertThrow(ok && !facets.empty(),
                ExcMessage("'File' is '" + file +
                           "'; expected a readable surface mesh: STL (.stl), "
                           "gmsh (.msh, ASCII 2 or 4), Abaqus (.inp) or VTK "
                           "(.vtk)."));
  }


  template void
  read_surface<2>(const std::string &,
                  std::vector<Tensor<1, 2>> &,
                  std::vector<std::vector<unsigned int>> &);
  template void
  read_surface<3>(const std::string &,
                  std::vector<Tensor<1, 3>> &,
                  std::vector<std::vector<unsigned int>> &);
} // namespace Structure
