// SPDX-License-Identifier: Apache-2.0
// Generates the man page in the macros of man(7).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/command/help.hpp"

namespace robochart::app {
namespace {

/// Escapes the text for troff, so that hyphens are ASCII hyphens and no line or character is taken as a command.
std::string roff_text(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '-')
            out += "\\-";
        else if (c == '\\')
            out += "\\e";
        else if (c == '`')
            out += "\\(oq";
        else if (c == '\'')
            out += "\\(cq";
        else
            out += c;
    }
    return out.starts_with('.') ? "\\&" + out : out;
}

std::string bold_text(std::string_view text) {
    return fmt::format("\\fB{}\\fR", roff_text(text));
}

std::string italic_text(std::string_view text) {
    return fmt::format("\\fI{}\\fR", roff_text(text));
}

/// Returns a tagged paragraph; both arguments are troff text.
std::string tagged_paragraph(const std::string& tag, const std::string& text) {
    return fmt::format(".TP\n{}\n{}\n", tag, text);
}

std::string section_heading(std::string_view name) {
    return fmt::format(".SH {}\n", name);
}

std::string synopsis_text() {
    std::string out = section_heading("SYNOPSIS");
    const std::string program = bold_text("robochart-verify");
    out += fmt::format("{} [{}] {}...\n", program, italic_text("OPTIONS"), italic_text("MODEL"));
    for (const VerbRow& row : verb_table())
        out += fmt::format(".br\n{} {}{}{}\n", program, bold_text(full_name(row)),
                           row.verb == Verb::version ? "" : fmt::format(" [{}]", italic_text("OPTIONS")),
                           row.input[0] == '\0' ? "" : " " + italic_text(row.input));
    return out;
}

std::string verbs_section() {
    std::string out = section_heading("VERBS");
    for (const VerbRow& row : verb_table())
        out += tagged_paragraph(bold_text(full_name(row)), roff_text(row.summary) + ".");
    return out;
}

std::string tag_of(const OptionRow& row) {
    std::string tag;
    if (!short_name(row).empty()) tag = bold_text(short_name(row)) + ", ";
    tag += bold_text(long_name(row));
    if (row.argument.kind != Argument::Kind::none) tag += " " + italic_text(row.argument.name);
    return tag;
}

std::string owning_verbs(const OptionRow& row) {
    std::vector<std::string> names;
    for (const VerbRow& verb : verb_table())
        if ((row.verbs & verb_bit(verb.verb)) != 0) names.push_back(full_name(verb));
    if (names.size() == verb_table().size()) return "all verbs";
    return names.empty() ? "without a verb" : fmt::format("{}", fmt::join(names, ", "));
}

std::string option_paragraph(const OptionRow& row) {
    std::string text = roff_text(row.help) + ".";
    if (const auto choices = choices_of(row.argument); !choices.empty())
        text += fmt::format("\nOne of {}.", roff_text(fmt::format("{}", fmt::join(choices, ", "))));
    if (row.argument.usual[0] != '\0') text += fmt::format("\nDefault: {}.", roff_text(row.argument.usual));
    if (row.argument.repeated) text += "\nMay be repeated.";
    return tagged_paragraph(tag_of(row), fmt::format("{}\n({})", text, italic_text(owning_verbs(row))));
}

std::string options_section() {
    std::string out = section_heading("OPTIONS") +
                      "The verbs that take an option are in brackets after it. Without a verb, the options of\n" +
                      bold_text("verify") + "\napply.\n";
    for (const Group group : option_groups()) {
        out += fmt::format(".SS {}\n", group_heading(group));
        for (const OptionRow& row : option_table())
            if (row.group == group) out += option_paragraph(row);
    }
    return out;
}

std::string exit_section() {
    std::string out = section_heading("\"EXIT STATUS\"");
    for (const ExitRow& row : exit_table())
        out += tagged_paragraph(bold_text(fmt::format("{}", static_cast<int>(row.exit))), roff_text(row.meaning) + ".");
    return out;
}

constexpr std::string_view description = R"(.SH DESCRIPTION
.B robochart\-verify
reads RoboChart models, reports errors, decides assertions in the CSP semantics, generates C++
controllers, and checks that this code refines the semantics.
.PP
.I MODEL
is a folder (a project: every .rct and .assertions file below it) or a file (together with the .rct files of its folder
that it needs; for assertions in a folder without models, those of the parent folder).
Independent projects are processed separately.
Results go to standard output, diagnostics and progress to standard error.
)";

constexpr std::string_view ranks = R"(.SH "SEVERAL PROCESSES"
.B robochart\-verify\-mpi
takes the same verbs and options. It exists if the command was built with MPI.
.B mpirun
or
.B srun
starts several of these programs. Each has one
.I rank
or, with
.BR \-\-threads ,
several; all ranks share the states of each search:
.PP
.RS
.nf
mpirun \-n 4 robochart\-verify\-mpi cspm model.csp
srun \-\-ntasks=64 robochart\-verify\-mpi cspm model.csp \-\-memory 3G
srun \-\-ntasks=4 \-\-cpus\-per\-task=16 robochart\-verify\-mpi cspm model.csp \-\-threads 16 \-\-memory 48G
.fi
.RE
.PP
Rank 0 reads, compiles and prints. Verdicts, counterexamples and exit status do not depend on the number of ranks.
.B \-\-memory
limits each program,
.B \-\-max\-states
all programs together.
All ranks must see the folder of
.BR \-\-checkpoint ,
.B \-\-resume
or
.BR \-\-disk ;
another number of ranks may continue from it, or
.B robochart\-verify
of the same build. If a rank fails, all end with the exit status of its error. If
.B mpirun
itself gets a signal, the results so far are printed, and mpirun decides the exit status.
)";

constexpr std::string_view closing = R"(.SH ENVIRONMENT
.TP
.B NO_COLOR
If it is set and not empty, text has no colours unless
.B \-\-color always
is given.
.TP
.B PATH
The folders that are searched for
.BR c++ ,
the compiler of generated code
.RB ( conform ,
.BR simulate ),
and for programs that convert pictures
.RB ( rsvg\-convert ,
.BR ffmpeg ).
.TP
.BR XDG_CACHE_HOME ", " HOME
Results for later runs are stored in the folder
.I robochart\-verify
below the former, or below
.I .cache
in the latter.
.TP
.B TMPDIR
The folder for temporary files;
.I /tmp
by default.
.SH FILES
.TP
.IR NAME .rct
A model.
.TP
.IR NAME .assertions
Assertions about a model.
.TP
.IR NAME .scenario
A scenario for
.BR simulate .
.TP
.IR NAME .trace
Logs of runs, for
.BR "conform \-\-traces" .
.TP
.I ~/.cache/robochart\-verify/
Answers and compiled code of earlier runs, unless
.B \-\-no\-cache
is given. You may remove it at any time.
.TP
.I out/
The default output folder;
.B \-\-out
sets another one:
.I csp\-gen/
for FDR,
.I cpp/
for the controllers,
.IR monitor/ ,
.IR tests/ ,
.IR simulation/ .
.SH EXAMPLES
.TP
.B robochart\-verify corpus/aggregation
Run all steps on a project.
.TP
.B robochart\-verify check model.rct \-\-assertion A1
Check one assertion.
.TP
.B robochart\-verify help conform
Show the options of a verb.
.SH "SEE ALSO"
.BR c++ (1)
)";

}  // namespace

std::string manual_page() {
    return fmt::format(
        ".\\\" Made by `robochart\\-verify help \\-\\-generate man`.\n"
        ".TH ROBOCHART\\-VERIFY 1 \"\" \"robochart\\-verify {}\" \"User Commands\"\n"
        ".SH NAME\nrobochart\\-verify \\- verify RoboChart models\n{}{}{}{}{}{}{}",
        program_version, synopsis_text(), description, verbs_section(), options_section(), exit_section(), ranks,
        closing);
}

}  // namespace robochart::app
