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
#include "itkTracingPage.h"

#include "itkDentalInputError.h"
#include "itkDentalSCRVersion.h"
#include "itkEscapeForScript.h"
#include "itkJsonDocument.h"
#include "itkRadiographForPage.h"
#include "itkTracingParts.h"

#include <nlohmann/json.hpp>

// Debian's 4.1 compares a character with a constant of another sign.
#if defined(__GNUC__)
#  pragma GCC diagnostic push
#  pragma GCC diagnostic ignored "-Wconversion"
#  pragma GCC diagnostic ignored "-Wshadow"
#endif
#include <kainjow/mustache.hpp>
#if defined(__GNUC__)
#  pragma GCC diagnostic pop
#endif

namespace itk
{
namespace
{
using Json = nlohmann::ordered_json;

/** A side beyond this is shrunk: a browser shows no larger picture at once, and a hand is no finer than half a pixel of
 * it. Radiographs of the usual machines have 2000 to 3000 pixels and stay as they are. */
constexpr unsigned int MaximumSide = 4096;

Json
ParseDrawn(const std::string & text, const char * name)
{
  if (text.empty())
  {
    return nullptr;
  }
  JsonDocument::Verify(text, name);
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object())
  {
    itkDentalInputErrorMacro(name, "", "is no JSON object", "give the text of a file that the toolkit writes");
  }
  return json;
}
} // namespace

std::string
MakeTracingPage(const TracingPageContent & content)
{
  if (content.radiograph.IsNull())
  {
    itkGenericExceptionMacro("There is no radiograph to trace: set TracingPageContent::radiograph.");
  }
  const auto size = content.radiograph->GetLargestPossibleRegion().GetSize();
  const auto picture = MakeRadiographForPage(content.radiograph, MaximumSide);
  const Json data = { { "title", content.title },
                      { "identity", content.identity },
                      { "image_size", { size[0], size[1] } },
                      { "picture_size", { picture.width, picture.height } },
                      // How tall a pixel is beside its width.
                      { "aspect", content.pixelSpacing[1] / content.pixelSpacing[0] },
                      { "markups_grid", content.markupsGrid },
                      { "contours", ParseDrawn(content.contours, "contours") },
                      { "landmarks", ParseDrawn(content.landmarks, "landmarks") },
                      { "served", content.served },
                      { "number", content.number },
                      { "saves_itself", content.savesItself },
                      { "contours_saved", content.contoursAreSaved },
                      { "landmarks_saved", content.landmarksAreSaved },
                      { "contours_file", content.contoursFile },
                      { "landmarks_file", content.landmarksFile },
                      { "can_register", content.canRegister } };
  // Names of files may be anything; what is shown of them is UTF-8.
  const std::string title =
    Json::parse(Json(content.title).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
  kainjow::mustache::data model;
  model.set("title", title);
  model.set("software", DentalSCRVersion);
  model.set("style", std::string(TracingParts::CommonStyle()) + std::string(TracingParts::Style()));
  model.set("connect", content.served ? "'self'" : "'none'");
  model.set("can_register",
            content.canRegister ? kainjow::mustache::data::type::bool_true : kainjow::mustache::data::type::bool_false);
  model.set("picture", picture.uri);
  model.set("data", EscapeForScript(data.dump(-1, ' ', false, Json::error_handler_t::replace)));
  model.set("script",
            std::string(TracingParts::DrawingScript()) + std::string(TracingParts::PictureScript()) +
              std::string(TracingParts::PageScript()));
  kainjow::mustache::mustache page{ std::string(TracingParts::Template()) };
  std::string                 text = page.render(model);
  if (!page.is_valid())
  {
    itkGenericExceptionMacro("The tracing page's template is wrong: " << page.error_message());
  }
  return text;
}
} // namespace itk
