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
#ifndef itkReportPageWriter_h
#define itkReportPageWriter_h

#include "ReportPageExport.h"

#include "itkImage.h"
#include "itkMesh.h"
#include "itkProcessObject.h"

#include <map>
#include <string>

namespace itk
{
/** \class ReportPageWriter
 * \brief Writes the page by which a person judges a registration: one HTML file that asks nothing of the network.
 *
 * Every number on the page is read from the result (the text of result.json) and from its details (report.json, what
 * lies on the radiograph: tracing, outlines, steps). The page stands without a script: verdict, findings with what to
 * do about them, the radiograph with everything that lies on it, all tables. A script, where the toolkit was built with
 * npm, adds plots and the scene in space; a smaller one, always there, the layers, zoom and flicker of the picture.
 *
 * Inputs, all optional: the radiograph, shown as it is (white bright) and recompressed; the scans of the jaws in the
 * cephalostat frame (mm), simplified to TrianglesPerScan triangles, and rendered onto each radiograph where the result
 * places them on it, as a layer of its own. What is not given is left out, and the page says so.
 *
 * Whatever stands in the result stays text: names may be hostile, and no browser runs them.
 *
 * Errors: DentalInputError for a result or details that are no JSON of this version, or a file that cannot be written.
 *
 * \ingroup ReportPage
 *
 * \test itkReportPageWriterGTest.cxx
 */
class ReportPage_EXPORT ReportPageWriter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ReportPageWriter);

  using Self = ReportPageWriter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ReportPageWriter, ProcessObject);

  using RadiographType = Image<float, 2>;
  using MeshType = Mesh<float, 3>;
  /** The lateral radiograph, where there is one. */
  itkSetInputMacro(Radiograph, RadiographType);
  itkGetInputMacro(Radiograph, RadiographType);

  /** Of a further view, by its name; null takes it away. */
  void
  SetViewRadiograph(const std::string & view, const RadiographType * radiograph);

  /** In the cephalostat frame, mm. */
  itkSetInputMacro(UpperScan, MeshType);
  itkGetInputMacro(UpperScan, MeshType);
  itkSetInputMacro(LowerScan, MeshType);
  itkGetInputMacro(LowerScan, MeshType);

  /** The text of result.json. */
  itkSetStringMacro(Result);
  itkGetStringMacro(Result);

  /** The text of report.json; "" (the default) where there is none: the page then has no drawing. */
  itkSetStringMacro(Details);
  itkGetStringMacro(Details);

  /** What the page is of, e.g. the name of the case's folder. */
  itkSetStringMacro(Title);
  itkGetStringMacro(Title);
  /** The page to write. Must be set. */
  itkSetStringMacro(FileName);
  itkGetStringMacro(FileName);

  /** Of the scene in space. Default 24 000: 0.4 mm on an arch. */
  itkSetMacro(TrianglesPerScan, unsigned int);
  itkGetConstMacro(TrianglesPerScan, unsigned int);

  /** The longer side of the radiograph in the page, pixels; a larger one is shrunk. Default 1600. */
  itkSetMacro(MaximumRadiographSide, unsigned int);
  itkGetConstMacro(MaximumRadiographSide, unsigned int);

  /** Whether the toolkit was built with the script that draws plots and the scene. */
  static bool
  HasBundle();

  /** The page's text. */
  std::string
  MakePage();

  /** A writer has no output: this brings its inputs up to date and writes, each time. */
  void
  Update() override;

protected:
  ReportPageWriter();
  ~ReportPageWriter() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::string                                         m_Result;
  std::string                                         m_Details;
  std::string                                         m_Title{ "Registration" };
  std::map<std::string, RadiographType::ConstPointer> m_ViewRadiographs;
  std::string                                         m_FileName;
  unsigned int                                        m_TrianglesPerScan{ 24000 };
  unsigned int                                        m_MaximumRadiographSide{ 1600 };
};
} // namespace itk

#endif
