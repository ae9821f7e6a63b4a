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
#include "dentalscrCommands.h"

#include "itkCasePresetNames.h"
#include "itkDentalSCRVersion.h"

#include <string>

namespace dentalscr
{
std::string
SlicerDescription()
{
  std::string presets;
  for (const std::string & name : itk::GetCasePresetNames())
  {
    presets += "      <element>" + name + "</element>\n";
  }
  // The verb is a hidden first argument: Slicer knows none.
  return std::string(R"(<?xml version="1.0" encoding="utf-8"?>
<executable>
  <category>Dental</category>
  <title>DentalSCR registration</title>
  <description>Aligns intraoral scans with a lateral cephalometric radiograph. Research software, not a medical device.</description>
  <version>)") +
         itk::DentalSCRVersion + R"(</version>
  <license>Apache-2.0</license>
  <contributor>The DentalSCR authors</contributor>
  <parameters>
    <label>Case</label>
    <description>What to register and where the result goes</description>
    <string-enumeration hidden="true">
      <name>verb</name>
      <label>Verb</label>
      <description>What the program does</description>
      <index>0</index>
      <default>register</default>
      <element>register</element>
    </string-enumeration>
    <file fileExtensions=".json">
      <name>caseFile</name>
      <label>Case file</label>
      <description>case.json: scans, tracing, geometry</description>
      <channel>input</channel>
      <index>1</index>
    </file>
    <directory>
      <name>output</name>
      <label>Result folder</label>
      <description>Gets result.json, overlays, the scans in the cephalostat frame and transforms</description>
      <channel>output</channel>
      <longflag>--output</longflag>
    </directory>
    <string-enumeration>
      <name>preset</name>
      <label>Preset</label>
      <description>How to register</description>
      <longflag>--preset</longflag>
      <default>)" +
         itk::GetCasePresetNames().front() + "</default>\n" + presets + R"(    </string-enumeration>
    <integer>
      <name>threads</name>
      <label>Threads</label>
      <description>0: all. The result is the same for any number</description>
      <longflag>--threads</longflag>
      <default>0</default>
      <constraints><minimum>0</minimum><maximum>1024</maximum><step>1</step></constraints>
    </integer>
  </parameters>
  <parameters>
    <label>Result</label>
    <description>What came out</description>
    <string>
      <name>status</name>
      <label>Status</label>
      <description>ok, suspect or failed</description>
      <channel>output</channel>
      <default></default>
    </string>
  </parameters>
</executable>
)";
}
} // namespace dentalscr
