/*=========================================================================
 *
 *  Copyright The DentalSCR authors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#ifndef itkViewForPage_h
#define itkViewForPage_h

#include "itkRadiographForPage.h"

#include "itkMesh.h"

#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <string>

namespace itk
{
/** \class ViewForPage
 * \brief Where a radiograph stands in space, and what the scans would look like on it.
 *
 * Of a view of report.json, by what result.json says of it. Everything is in the first view's cephalostat frame, in
 * which the scans are given (mm), and from the jaws' projections alone: a lateral and a further view, with a scale that
 * was estimated or a similarity in the image, are no different. Without a jaw in perspective, an image size or
 * distances a view is nowhere. Throws nlohmann's exceptions where the result is not as this version writes it.
 */
class ViewForPage
{
public:
  using Json = nlohmann::ordered_json;
  using MeshType = Mesh<float, 3>;
  /** By jaw, "upper" and "lower". */
  using ScansType = std::map<std::string, const MeshType *>;

  /** \param result what is said of the case, result.json
   *  \param own    what is said of this view: result.json again, or one of its views
   *  \param view   one of the views of report.json */
  ViewForPage(const Json & result, const Json & own, const Json & view);

  /** Source, the place where the central ray meets the detector, and the detector's corners from pixel edge to pixel
   * edge, upper left, upper right, lower right, lower left, as SceneDetector has them; the mean of both jaws' where
   * these were scaled apart. Null where the view is nowhere. */
  Json
  GetSpace() const;

  /** What the scans would look like on this radiograph: SurfaceDRRImageSource's shells of 1 mm, dense is bright, in
   * pixels of the radiograph or, where a side is longer than asked for, in blocks of them as MakeRadiographForPage()
   * has them. Empty where the view is nowhere or has no scan. */
  RadiographForPage
  MakeDRR(const ScansType & scans, unsigned int maximumSide) const;

private:
  std::map<std::string, std::array<double, 12>> m_Projections;
  double                                        m_SourceToDetector{ 0.0 };
  std::array<std::size_t, 2>                    m_Size{ { 0, 0 } };
};
} // namespace itk

#endif
