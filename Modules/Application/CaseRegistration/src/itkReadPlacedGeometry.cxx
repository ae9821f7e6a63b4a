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
#include "itkReadPlacedGeometry.h"

#include "itkCaseResultDocument.h"
#include "itkDentalInputError.h"
#include "itkDescribePlainly.h"
#include "itkPlaceByProjection.h"
#include "itkProjectionRows.h"

namespace itk
{
namespace
{
/** A member without which there is no place; the path of one that is missing names it. */
JsonNode
Require(const JsonNode & node, const std::string & key, const std::string & problem, const std::string & remedy)
{
  if (const auto member = node.Find(key))
  {
    return *member;
  }
  const std::string & path = node.GetPath();
  itkDentalInputErrorMacro(node.GetFileName(), (path.empty() ? "" : path + '.') + key, problem, remedy);
}
} // namespace

CephalometricGeometry::Pointer
ReadPlacedGeometry(const std::string & result, ToothCode::JawEnum jaw, const std::string & view)
{
  const CaseResultDocument document(result);
  const JsonNode           own = document.GetView(view);
  const std::string        reasons = "its reasons stand in the result; register the case again when they are mended";
  const JsonNode node = Require(own.Get("jaws"), ToString(jaw), "missing: the jaw was not registered", reasons);
  const JsonNode placed =
    Require(node, "projection_3x4", "missing: the jaw failed and has no place on the radiograph", reasons);
  const auto geometry = CaseResultDocument::ReadGeometry(own.Get("geometry"));
  const auto projection = CaseResultDocument::ReadMatrix<3, 4>(placed, "[p, p, p, p]");
  try
  {
    PlaceByProjection(ScaleColumns(projection, 1.0 / document.GetMillimetresPerUnit()), geometry);
  }
  catch (const ExceptionObject & problem)
  {
    placed.Fail(DescribePlainly(problem), "register the case again");
  }
  return geometry;
}
} // namespace itk
