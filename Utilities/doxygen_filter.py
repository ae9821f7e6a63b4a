"""Doxygen's input filter for our headers: doxygen_filter.py FILE, to standard output; Utilities/doxygen.sh runs it.

The headers are written as ITK's are, where a comment is about all declarations up to the next empty line or comment: a setter
and its getter, an alias beside another. Doxygen takes it for the first one's alone, and so a comment before several becomes one
of a group. What every ITK class has, its names for itself and the methods that the pipeline calls, needs no comment in each
header, and gets its words here; so does what means the same in every header of ours: names of types, a jaw's inputs.
"""
import pathlib
import re
import sys

# Of a declaration without a comment: what it matches, and what is said of it.
COMMON = (
    (r"using Self = ", "This class."),
    (r"using Superclass = ", "The class that this one is derived from."),
    (r"using Pointer = ", "Smart pointer to an object of this class."),
    (r"using ConstPointer = ", "Smart pointer to an object of this class that can't be changed through it."),
    (r"itkTypeMacro\(", "Name of the class, as PrintSelf() and errors show it."),
    (r"itk(Simple|Factoryless)?NewMacro\(", "Makes an object, by the object factory where one overrides the class."),
    (r"itkCloneMacro\(", "Copy of the object with its settings."),
    (r".*\bPrintSelf\(.*\boverride\b", "Writes the settings of the object, one a line."),
    (r".*\bGenerateData\(.*\boverride\b", "Computes the outputs; Update() calls it."),
    (r".*\bGenerateOutputInformation\(.*\boverride\b", "Says what the outputs will be, before they are computed."),
    (r".*\bGenerateInputRequestedRegion\(.*\boverride\b", "Asks for as much of the inputs as is needed: all of them."),
    (r".*\bEnlargeOutputRequestedRegion\(.*\boverride\b", "Outputs are computed as wholes."),
    (r".*\bVerifyPreconditions\(.*\boverride\b", "Throws where an input or a setting is missing or wrong, before anything is computed."),
    (r".*\bVerifyInputInformation\(.*\boverride\b", "Inputs need not lie in one space: a mesh is in mm and a radiograph in pixels."),
    (r".*\bMakeOutput\(.*\boverride\b", "Makes an output of the type that its place in the list has; ProcessObject calls it."),
    (r".*\bGraft\(.*\boverride\b", "Takes over what another object of this type holds."),
    (r".*\bInternalClone\(.*\boverride\b", "Copy of the object; Clone() calls it."),
    (r".*\bGetMTime\(.*\boverride\b", "Time of the last change of the object, and of what it holds."),
    (r".*\b(Set|Get|Has)(Upper|Lower)Mesh\(|itk[SG]etInputMacro\((Upper|Lower)Mesh,", "Scan of that jaw, mm, in a frame of its own."),
    (r".*\bInitialize\(\) override;", "Takes everything out; the pipeline calls it before it writes anew, or frees what is held."),
    (r".*\bHold\(HoldEnum what\) override;", "As LeastSquaresMetricv4::Hold()."),
    (r".*\b(GetValue|GetDerivative|GetValueAndDerivative)\(.*\boverride\b", "At the current parameters; optimizers call it."),
    (r".*\b(GetNumberOf(Local)?Parameters|GetMetricCategory|HasLocalSupport)\(\) const override\b", "Of a metric of a few parameters; optimizers ask for it."),
    (r".*\b([SG]etParameters|UpdateTransformParameters)\(.*\boverride\b", "The parameters that are optimized, in the optimizer's units; optimizers call it."),
    (r".*\b(overflow|xsputn|sync)\(.*\boverride\b", "What a stream asks of its buffer."),
    # Enumerations say by their values what they are; these are the words of their pages.
    (r"enum class Study :", "What an experiment asks."),
    (r"enum class JawsEnum :", "The scans that a case has."),
    (r"enum ErrorClass :", "By the mean error of the jaw."),
    (r"enum Verdict :", "By the status of the jaw."),
    (r"enum class Mistake :", "What is done wrong."),
    (r"enum class ProblemEnum\b", "Why a file can't be read."),
    (r"enum class JawEnum :", "The jaw of a tooth."),
    (r"enum class MethodEnum :", "How splats are added up."),
    (r"enum class KindEnum : uint8_t", "What it is."),
    (r"enum class Measure :", "What is the same in both pictures."),
    (r"enum class SearchEnum :", "How the nearest place is looked for; the answer is the same."),
    (r"enum class ViewEnum :", "From where the picture is taken."),
    (r"enum class ArchFamilyEnum :", "Forms of dental arches."),
    (r"enum class RoleEnum :", "What a contour is of."),
    (r"itk[SG]etEnumMacro\(Question,", "Which of them is asked; Sides by default."),
    # Two constructors that stand first in their classes.
    (r"ProgressLine\(", "Watches the process and shows its progress, behind what stage() says, unless it is to be quiet."),
    (r"Rendering\(", "Adds to the pixels of the region; rows of the buffer are stride numbers apart."),
    (r"(friend )?[\w ]*\boperator(==|!=|<)\(", "Compares all that the objects hold."),
    (r"friend [\w:& ]*\boperator<<\(", "Writes it as a line of text."),
    (r"(\w+ & operator=|\w+)\((const )?\w+ &&?\) = default;", "Copies or moves all that the object holds."),
    (r".*= delete;", "Not for use: the object is not copied."),
    (r"~\w+\(\)|virtual ~\w+\(\)", "Destroys the object; with objects of ITK the last smart pointer does."),
)

# Names that mean the same wherever a header of ours defines them: name, what it stands for where one name has several meanings, words.
ALIASES = (
    ("DataObjectPointer", "", "Smart pointer to an input or an output."),
    ("DataObjectPointerArraySizeType", "", "Number of an input or an output."),
    ("AcquisitionType", "", "How the radiograph is taken and traced."),
    ("AxisType", "", "The filter that finds the dental frames."),
    ("BlockType", "", "Parameters that belong together."),
    ("BlocksType", "", "The blocks of a state, in its order."),
    ("CohortEnum", "", "Cohorts, from ideal cases to hard ones."),
    ("ContentEnum", "", "What a pixel's value says."),
    ("ContourType", "", "A tracing or a silhouette, continuous pixel indices."),
    ("CountsType", "", "Jaws by verdict and error."),
    ("CovarianceType", "", "2x2, square pixels."),
    ("DataPointer", "", "A case that several may read."),
    ("DecoratedFindingsType", "", "Findings as an output of the pipeline."),
    ("DecoratedMatrixType", "", "A projection matrix as an output of the pipeline."),
    ("DecoratedRealType", "", "A number as an output of the pipeline."),
    ("DecoratedTransformType", "", "A transform as an input or an output of the pipeline."),
    ("DecoratedVerdictType", "", "A verdict as an output of the pipeline."),
    ("DirectionEnum", "ContourMetric", "From which contour to which distances are measured."),
    ("DirectionEnum", "", "From where the radiograph was taken."),
    ("DistanceEnum", "", "How a point's distance counts."),
    ("DraftsType", "", "Polylines by jaw, continuous pixel indices."),
    ("EdgeType", "", "Indices of the two points of an edge."),
    ("FacingEnum", "", "Whether the patient faces right or left in the picture."),
    ("FieldType", "", "A member of the level, whatever its type."),
    ("FileFormatEnum", "", "Formats of files of annotations."),
    ("FindingsType", "", "Findings in the order in which they were made."),
    ("FixedLandmarksType", "", "Landmarks of the radiograph, continuous pixel indices."),
    ("FrameEnum", "", "In which frame the meshes are."),
    ("FrameObjectType", "", "Everything that was found of the frames."),
    ("FrameType", "", "A jaw's frame, mesh (mm) to dental frame, as an input or an output of the pipeline."),
    ("FrontalSourceEnum", "", "Whether the source of a frontal radiograph was behind the patient or in front."),
    ("FunctionType", "", "Residuals at a position."),
    ("GeometryType", "", "Source, detector, pixels and where the object is in them."),
    ("GradientType", "", "By scale, angle and the two shifts."),
    ("GroupEnum", "", "Groups of teeth that the paper's tables have."),
    ("ImageSizeType", "", "Width and height, pixels."),
    ("ImageType", "", "A radiograph."),
    ("IndexType", "", "Of a pixel."),
    ("InputImageType", "", "The image that is read."),
    ("InputMeshType", "", "The mesh that is read, mm."),
    ("InputType", "", "What the filter reads."),
    ("IterationType", "", "What is told of an iteration."),
    ("JawEnum", "", "Upper or lower."),
    ("JawSurface", "", "One jaw as a mesh, with what is known of it."),
    ("JawVerdictType", "", "Status and findings of a jaw."),
    ("JawsShareFrameEnum", "", "Whether both scans lie in one frame."),
    ("LabelContainerType", "", "FDI number a point, 0 where there is no tooth."),
    ("LabelObjectType", "", "Labels as an output of the pipeline."),
    ("LabelsType", "", "FDI number a point, 0 where there is no tooth."),
    ("Landmark", "", "A named point, mm."),
    ("LandmarkSetType", "", "Named landmarks."),
    ("Landmarks2DType", "", "Landmarks of a radiograph, continuous pixel indices."),
    ("Landmarks3DType", "", "Landmarks of a scan, in its unit and frame."),
    ("LandmarksType", "Cephalometric", "Landmarks of an analysis, continuous pixel indices."),
    ("LandmarksType", "", "Landmarks of a scan, in its unit and frame."),
    ("LevelEnum", "", "Where the contour runs between inside and outside."),
    ("LevelResultType", "", "How a level went."),
    ("LevelType", "", "Settings of a level, coarse to fine."),
    ("LoopType", "", "Points of a closed line, in order."),
    ("MaskImageType", "", "The mask."),
    ("MaskType", "", "1 a triangle that is kept, else 0."),
    ("MatrixType", "", "Rows are residuals, columns parameters."),
    ("MeasureEnum", "", "How grey values are compared."),
    ("MeshSourceType", "", "What makes the meshes."),
    ("MeshType", "", "A scan: triangles, mm."),
    ("MetricType", "", "The criterion that is minimized."),
    ("MotionEnum", "", "What may be estimated: a shift, a rigid motion, a similarity."),
    ("MovingLandmarksType", "", "Landmarks of the scan, in its unit and frame."),
    ("NormalContainerType", "", "Unit normals in the picture."),
    ("NormalizationEnum", "", "How grey values are scaled."),
    ("NumberingEnum", "", "How teeth are numbered."),
    ("OffsetType", "", "A shift in pixels."),
    ("OptimizerParametersType", "", "Parameters in the optimizer's units."),
    ("OptimizerType", "", "Any optimizer of ITK's v4 framework."),
    ("OutputCoordinatesEnum", "", "Whether points are physical or continuous indices."),
    ("OutputDecoratorType", "", "The copy as an output of the pipeline."),
    ("OutputEnum", "", "What a pixel of the output holds."),
    ("OutputImageType", "", "The image that is made."),
    ("OutputMeshType", "", "The mesh that is made."),
    ("OutputType", "", "What the filter makes."),
    ("ParametersType", "DentalPhantom", "What the jaws are made of."),
    ("ParametersType", "", "Parameters in the optimizer's units."),
    ("PartsType", "", "What is shown, in order."),
    ("PatientLeftEnum", "", "Where a frontal radiograph shows the patient's left."),
    ("PictureSizeType", "", "Width and height, pixels."),
    ("PictureType", "", "A picture in colours or in grey."),
    ("PixelIndexType", "", "Continuous pixel index, (u, v)."),
    ("PixelOriginEnum", "", "Where a file counts its pixels from."),
    ("PixelSpacingType", "", "mm, (u, v)."),
    ("PixelType", "TOutputImage", "Of the output."),
    ("PixelType", "", "Continuous pixel index, (u, v)."),
    ("PlaneObjectType", "", "The plane as an output of the pipeline."),
    ("PointJacobianType", "", "Pixels a mm of the point: 2x3."),
    ("PointType", "", "A place, in the unit and the frame that the class says."),
    ("PolylinesType", "", "Stretches of contour, in order."),
    ("PoseJacobianType", "", "Pixels a radian and a mm of the pose: 2x6."),
    ("PositionType", "", "All parameters of the state, free or held, natural units."),
    ("ProgressType", "", "Is told the share that is done, 0 to 1."),
    ("ProjectionMatrixType", "", "3x4, from homogeneous mm to homogeneous pixels."),
    ("RadiographType", "", "The radiograph's grey values."),
    ("RealObjectType", "", "A number as an output of the pipeline."),
    ("RegionType", "", "Of the output."),
    ("RigidTransformType", "", "Rotation and shift, mm."),
    ("RimContainerType", "", "Points of the surface, mm."),
    ("RotationType", "", "3x3, of determinant 1."),
    ("RowsType", "", "3x4, row-major."),
    ("RuleEnum", "", "By what a landmark was found."),
    ("SamplesType", "", "Samples of the silhouette, in order."),
    ("ScanLandmarksType", "", "Landmarks of a scan, in its unit and frame."),
    ("SearchEnum", "", "How the nearest place is looked for."),
    ("SideEnum", "", "The patient's right or left."),
    ("SigmasType", "", "Standard deviations of the seven parameters."),
    ("SimilarityType", "", "Scale, angle and shift in the picture."),
    ("SixType", "", "Three angles (rad) and three shifts (mm)."),
    ("SizeType", "", "Width and height, pixels."),
    ("SolutionType", "", "What the registration found."),
    ("SpacingType", "", "mm a pixel, (u, v)."),
    ("StatisticsObjectType", "", "Statistics as an output of the pipeline."),
    ("StatusEnum", "", "ok, suspect or failed."),
    ("StopConditionEnum", "", "Why the run ended."),
    ("StudyEnum", "", "What is asked."),
    ("SurfacePointer", "", "A surface that several may read."),
    ("TermType", "", "One term of the criterion."),
    ("ThresholdsType", "", "Limits of the verdict."),
    ("TracedSideEnum", "", "The side whose outline was traced."),
    ("TransformType", "CephalometricPose", "From the dental frame (mm) to pixels."),
    ("TransformType", "VersorRigid3D", "From the mesh (mm) to its dental frame."),
    ("TransformType", "", "From the moving contour's picture to the fixed one's, pixels."),
    ("TranslationType", "", "mm."),
    ("TriangleType", "", "Indices of three points."),
    ("VectorType", "vnl", "One number a residual or a parameter."),
    ("VectorType", "", "A direction or a distance, in the unit and the frame that the class says."),
)
# Macros of ITK that declare several methods: a comment before one is about all of these.
MACROS_OF_SEVERAL = r"itk(SetGetDecorated(Object)?InputMacro|GetModifiableObjectMacro|BooleanMacro)\("


def declarations(lines, start):
    """From the line after a comment: (first line, one past the last) of each declaration up to an empty line or a comment."""
    found, at = [], start
    while at < len(lines):
        text = lines[at].strip()
        if not text or text.startswith(("/*", "//", "public", "protected", "private", "}", "#")):
            break
        first, depth, ended = at, 0, False
        while at < len(lines) and not ended:
            bare = re.sub(r'"(\\.|[^"\\])*"|//.*|/\*.*?\*/', "", lines[at])
            depth += sum(map(bare.count, "({")) - sum(map(bare.count, ")}"))
            # An enumerator, which ends with a comma or the brace of the whole, is no declaration of its own.
            if depth < 0 or depth == 0 and (bare.strip().startswith("/*") or bare.rstrip().endswith(",") and at == first):
                return found
            at += 1
            # A declaration ends with a semicolon, or with the brace of its body.
            ended = depth == 0 and re.search(r"[;}]\s*$|^\s*itk\w+Macro\(.*\)\s*$", bare) is not None
        # That an object can't be copied is said in a word, and by no comment.
        if not ended or re.search(r"= delete;$", lines[at - 1]):
            return found
        found.append((first, at))
    return found


def common_words(declaration):
    """What is said of a declaration that every class of ITK has; None of any other."""
    text = ""
    for line in declaration:
        text += " " * bool(text) + line.strip()
        if re.search(r"[;{}]$|^itk\w+Macro\(.*\)$", text):
            break
    alias = re.match(r"using (\w+) = ([^;]*)", text)
    if alias:
        named = (words for name, meaning, words in ALIASES if name == alias[1] and meaning in alias[2])
        return next(named, next((words for pattern, words in COMMON if re.match(pattern, text)), None))
    return next((words for pattern, words in COMMON if re.match(pattern, text)), None)


def filtered(lines):
    """The lines, as many as before: comments about several declarations are those of groups, and ITK's idioms have words."""
    marks = [""] * len(lines)
    at = 0
    while at < len(lines):
        if re.match(r"\s*/\*\*(?!/|<)", lines[at]):
            first = at
            while "*/" not in lines[at]:
                at += 1
            at += 1
            # What begins a block is one thing, and a comment that names its subject is about that.
            named = re.search(r"[\\@](class|struct|enum|file|mainpage|defgroup|namespace|fn|var|name)\b|[\\@][{}]", "\n".join(lines[first:at]))
            about = declarations(lines, at)
            several = about and any(re.match(MACROS_OF_SEVERAL, lines[first].strip()) for first, _ in about)
            opens = about and re.match(r"\s*(template|class|struct|union|enum|namespace|extern)\b", lines[about[0][0]])
            if about and (named or opens):
                about = about[:1]
                if re.search(r"\{\s*$", lines[at]) or lines[at + 1 : at + 2] and lines[at + 1].strip() == "{" or named:
                    continue  # into the block
            if (len(about) > 1 or several) and not lines[about[-1][1]].startswith("#"):
                marks[first] += "/**@{*/ "
                marks[about[-1][1]] += "/**@}*/ "
            if about:
                at = about[-1][1]
        else:
            starts = at == 0 or re.search(r"(^\s*|[;{}:)]|\*/)$", lines[at - 1])
            words = common_words(lines[at : at + 3]) if starts else None
            if words:
                marks[at] += f"/** {words} */ "
            at += 1
    # A name of the superclass that is made visible again is no member: a comment before it is about what follows.
    return [mark + re.sub(r"^\s*using Superclass::\w+;$", "", line) for mark, line in zip(marks, lines)]


if __name__ == "__main__":
    print("\n".join(filtered(pathlib.Path(sys.argv[1]).read_text().split("\n"))), end="")
