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
// Many cases from a table, one row of results a case; a case that can't be registered does not end the run.
#include "itkCaseLandmarkErrorFilter.h"
#include "itkCaseRegistration.h"
#include "itkCaseResultFolderWriter.h"
#include "itkDentalCaseReader.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

namespace
{
using RowType = std::map<std::string, std::string>;

/** Fields of a line; no quotes. */
std::vector<std::string>
Split(std::string line)
{
  if (!line.empty() && line.back() == '\r')
  {
    line.pop_back();
  }
  std::vector<std::string> fields;
  std::stringstream        stream(line);
  for (std::string field; std::getline(stream, field, ',');)
  {
    fields.push_back(field);
  }
  return fields;
}

/** The columns that are known make a case; files are relative to the table. */
itk::DentalCase
MakeCase(RowType & row, const std::filesystem::path & folder)
{
  const auto file = [&](const char * column) {
    return row[column].empty() ? std::string() : (folder / row[column]).string();
  };
  itk::DentalCase dentalCase;
  dentalCase.fileName = row["CaseID"];
  dentalCase.upperFile = file("Upper");
  dentalCase.lowerFile = file("Lower");
  dentalCase.imageFile = file("Cephalogram");
  dentalCase.contoursFile = file("Contour");
  dentalCase.landmarks3DFile = file("Landmarks3D");
  dentalCase.landmarks2DFile = file("Landmarks2D");
  if (!row["Spacing"].empty())
  {
    const double spacing = std::stod(row["Spacing"]);
    dentalCase.pixelSpacing = { { spacing, spacing } };
  }
  if (!row["PrincipalU"].empty() && !row["PrincipalV"].empty())
  {
    dentalCase.principalPoint = { { std::stod(row["PrincipalU"]), std::stod(row["PrincipalV"]) } };
  }
  return dentalCase;
}

/** Registers, writes the case's folder; status and errors of the jaws. */
std::string
Register(const itk::DentalCase & dentalCase, const std::string & output)
{
  auto reader = itk::DentalCaseReader::New();
  reader->SetDescription(dentalCase);
  auto registration = itk::CaseRegistration::New();
  registration->SetPreset(itk::CasePresetEnum::Robust);
  registration->SetInput(reader->GetOutput());
  // Below the registration: what is marked on the radiograph cannot help it.
  auto errors = itk::CaseLandmarkErrorFilter::New();
  errors->SetInput(registration->GetOutput());
  auto writer = itk::CaseResultFolderWriter::New();
  writer->SetInput(errors->GetOutput());
  writer->SetFolderName(output);
  writer->WriteReportOff();
  writer->Update(); // runs all of the above
  const itk::CaseResult & result = errors->GetOutput()->Get();
  std::ostringstream      row;
  row << itk::ToString(result.GetStatus());
  for (const auto jaw : { itk::ToothCode::JawEnum::Upper, itk::ToothCode::JawEnum::Lower })
  {
    row << ',';
    const auto found = result.jaws.find(jaw);
    if (found != result.jaws.end() && found->second.error)
    {
      row << found->second.error->mean;
    }
  }
  return row.str();
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " cases.csv folder" << std::endl;
    return EXIT_FAILURE;
  }
  std::ifstream input(argv[1]);
  std::string   line;
  if (!std::getline(input, line))
  {
    std::cerr << argv[1] << ": can't be read" << std::endl;
    return EXIT_FAILURE;
  }
  const std::string header = line;
  const auto        columns = Split(line);
  const auto        folder = std::filesystem::path(argv[1]).parent_path();
  std::filesystem::create_directories(argv[2]);
  std::ofstream table(std::filesystem::path(argv[2]) / "results.csv");
  table << header << ",Status,UpperError_px,LowerError_px,Error\n";
  unsigned int cases = 0;
  unsigned int registered = 0;
  while (std::getline(input, line))
  {
    RowType    row;
    const auto fields = Split(line);
    for (std::size_t i = 0; i < columns.size() && i < fields.size(); ++i)
    {
      row[columns[i]] = fields[i];
    }
    std::string result;
    try
    {
      result = Register(MakeCase(row, folder), (std::filesystem::path(argv[2]) / row["CaseID"]).string()) + ",";
    }
    catch (const itk::ExceptionObject & error)
    {
      std::string text = error.GetDescription();
      std::replace(text.begin(), text.end(), ',', ';');
      std::replace(text.begin(), text.end(), '\n', ' ');
      result = "error,,," + text;
    }
    catch (const std::exception & error)
    {
      result = std::string("error,,,") + error.what();
    }
    // Every column of the input comes back, whatever it means.
    table << line << ',' << result << std::endl;
    std::clog << row["CaseID"] << ": " << result << std::endl;
    ++cases;
    registered += result.compare(0, 5, "error") != 0 ? 1 : 0;
  }
  std::cout << "cases: " << cases << "\nregistered: " << registered << std::endl;
  return EXIT_SUCCESS;
}
