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
#ifndef itkReportPicture_h
#define itkReportPicture_h

#include "itkRadiographForPage.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** \class ReportPicture
 * \brief One radiograph with everything that lies on it, as SVG that stands in a page.
 *
 * Each kind of thing is a group of its own (class "layer", data-layer) that a script shows and hides; drawn by the
 * pixel, so that zooming is a change of the viewBox. Lines keep their width.
 */
class ReportPicture
{
public:
  using Json = nlohmann::ordered_json;

  /** `result` is result.json, `view` one of the views of report.json; `radiograph` and `drr`, what the scans would look
   * like on it, may be empty. */
  ReportPicture(const Json &              result,
                const Json &              view,
                const RadiographForPage & radiograph,
                const RadiographForPage & drr = {});

  const std::string &
  GetSVG() const
  {
    return m_SVG;
  }

  /** A layer's key, its name for a person, and whether it is shown at first. */
  struct LayerType
  {
    std::string key;
    std::string label;
    bool        shown{ true };
  };
  const std::vector<LayerType> &
  GetLayers() const
  {
    return m_Layers;
  }
  /** Keys and names of what can be compared with the result: the stages' starts. */
  const std::vector<std::pair<std::string, std::string>> &
  GetStages() const
  {
    return m_Stages;
  }

private:
  using PointType = std::pair<double, double>;

  void
  AddLayer(const std::string & key, const std::string & label, bool shown, const std::string & content);
  /** Makes room for a point in the first view. */
  void
  Include(const PointType & point);
  std::string
  DrawTracing(const std::string & jaw, const Json & drawing);
  std::string
  DrawContour(const std::string & jaw, const Json & polylines, const char * style);
  std::string
  DrawOutline(const Json & points, const Json & projection) const;
  std::string
  DrawMoved(const Json & polylines, const Json & from, const Json & to) const;
  std::string
  DrawRegions(const Json & jaw) const;
  void
  DrawLandmarks(const Json & jaw, std::string & predicted, std::string & errors, std::string & names);
  std::string
  DrawUsed(const Json & jaw, const Json & drawing) const;

  std::string                                      m_SVG;
  std::vector<LayerType>                           m_Layers;
  std::vector<std::pair<std::string, std::string>> m_Stages;
  std::string                                      m_Groups;
  double                                           m_Low[2]{ 0, 0 };
  double                                           m_High[2]{ 0, 0 };
  bool                                             m_Empty{ true };
  /** Pixels of the radiograph in a millimetre of the detector. */
  double m_Unit{ 4.0 };
};
} // namespace itk

#endif
