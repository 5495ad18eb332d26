"""What of a page is for people to run: command lines and programs, in blocks and within sentences."""

import re

# What begins a command line, or names a file of the project, within a sentence.
COMMAND = re.compile(r"^(graze|graze_\w+|bash|cmake|ctest|build/release/\S+|tests/\S+|samples/\S+|\.ci/\S+)( |$)")
PLACE = re.compile(r"^(bvh|narrowphase|engine|tests|samples|data|build|\.ci)/")
# A line of a drawing that follows a call: what is called, two blanks or more, where it stands.
STEP = re.compile(r"^ *(\S.*?)  +(\S+/\S*)(?:  +.*)?$")


class Page:
    """`commands` are lines, `places` names of files and folders, `programs` are (language, text), `steps` are (what is
    called, place)."""

    def __init__(self, text):
        self.commands, self.places, self.programs, self.steps = [], [], [], []
        prose = self._take_blocks(text)
        for span in re.findall(r"(?<!`)`([^`]+)`(?!`)", prose):
            span = " ".join(span.split())
            if " " in span and COMMAND.match(span):
                self.commands.append(span)
            elif " " not in span and PLACE.match(span):
                self.places.append(span)

    def _take_blocks(self, text):
        """Reads the blocks, and returns what is left."""
        prose, block, language, blank_before = [], [], None, True
        for line in text.splitlines() + [""]:
            if language is not None:
                if line.startswith("```"):
                    self._end_block(language, block)
                    language = None
                else:
                    block.append(line)
            elif line.startswith("```"):
                language, block = line[3:].strip(), []
            elif line.startswith("    ") and blank_before:
                self.commands += lines_of([line[4:]])
                continue  # the block goes on with the next line
            else:
                prose.append(line)
            blank_before = not line.strip()
        if language is not None:
            raise ValueError("a block without an end")
        return "\n".join(prose)

    def _end_block(self, language, block):
        if language == "text":  # a drawing
            found = [STEP.match(line) for line in block]
            self.steps += [(step[1], step[2]) for step in found if step and PLACE.match(step[2])]
            return
        if language:
            self.programs.append((language, "\n".join(block) + "\n"))
        else:
            self.commands += lines_of(block)


def lines_of(block):
    """The commands of a block: what stands before two blanks that are not within quotes is the command."""
    commands = []
    for line in block:
        quotes, end = 0, len(line)
        for at, character in enumerate(line):
            quotes ^= character == '"'
            if not quotes and line.startswith("  ", at):
                end = at
                break
        if line[:end].strip():
            commands.append(line[:end].strip())
    return commands


def examples_of(help_text):
    """The lines below `Examples:`."""
    found = re.search(r"^Examples:\n((?:  .*\n)+)", help_text, re.MULTILINE)
    return lines_of([line.strip() for line in found.group(1).splitlines()]) if found else []


def links_of(text):
    """Where links and pictures of a page lead that stay within the project."""
    prose = re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)
    targets = re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", prose)
    return [target for target in targets if "://" not in target]
