# SPDX-License-Identifier: BSD-3-Clause
"""scripts/lint, once everything needed is installed: holds the style and looks for slips, a line a tool."""
import argparse
import fnmatch
import os
import re
import shutil
import subprocess
import sys

from .places import ROOT, SPACE

CLANG = 14        # the version of clang-format and clang-tidy that the style was made with; others find other things
WORDS = 'ot,fro,expcet,kinf'  # codespell takes these for misspelt: optimal time, to and fro, a misspelt key in a test
# Names of types that do not say what they hold, and comments that begin without their noun.
DIALECT = (r'\b(struct|class) (Kept|Lead|Look|Answer|Leaving|Shell)\b|//+ *(So|Of so|For so|At so|Up to so) (long|much|many|far|often)\b'
           r'|//.*\bso (long|much) (later|before|after)\b|// (It|They) do(es)?,')
MADE = ('.git', 'build', 'install', 'log', 'report')  # by whoever works here
LEFT_OUT = 77     # exit status where no tool could be run
COMPAT = ('nav_core', 'costmap_2d', 'map_server', 'move_base')


def all_files():
    """The project's files; where git knows of none (no repository, or somebody else's), all that lie there."""
    listed = subprocess.run(['git', '-C', ROOT, 'ls-files'], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
    paths = listed.stdout.splitlines()
    if not paths:
        for folder, inner, names in os.walk(ROOT):
            if folder == ROOT:
                inner[:] = [name for name in inner if name not in MADE]
            paths += [os.path.relpath(os.path.join(folder, name), ROOT) for name in names]
    return sorted(path for path in paths if os.path.isfile(os.path.join(ROOT, path)))


def files(*patterns):
    """Those with these names; a folder counts with all that it holds."""
    return [path for path in all_files() if any(fnmatch.fnmatch(path, pattern) for pattern in patterns)]


def shell_scripts():
    """Those that begin with bash's line; what they source is looked at with them."""
    found = []
    for path in files('scripts/*', 'test/*', '.ci/*'):
        with open(os.path.join(ROOT, path), 'rb') as script:
            first = script.readline()
        if first.startswith(b'#!') and b'bash' in first:
            found.append(path)
    return found


def changed_sources():
    """Sources that differ from what is upstream, or where nothing does from the commit before, and those that include a header
    that does."""
    def git(*words):
        return subprocess.run(['git', '-C', ROOT, *words], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False).stdout
    base = git('merge-base', 'HEAD', '@{upstream}').strip()
    if not base or base == git('rev-parse', 'HEAD').strip():
        base = 'HEAD~1'
    changed = set(git('diff', '--name-only', base).splitlines()) | set(git('ls-files', '--others', '--exclude-standard').splitlines())
    headers = {'/'.join(path.split('/')[-2:]) for path in changed if path.endswith('.hpp')}
    found = []
    for path in files('src/*.cpp', 'lab/*.cpp'):
        with open(os.path.join(ROOT, path), encoding='utf-8') as text:
            included = {'/'.join(name.split('/')[-2:]) for name in re.findall(r'^#include "(.*)"', text.read(), re.MULTILINE)}
        if path in changed or included & headers:
            found.append(path)
    return found


def version_of(name):
    """The main version of a tool of clang's; None where it says nothing of the kind."""
    said = subprocess.run([name, '--version'], stdout=subprocess.PIPE, text=True, check=False).stdout
    version = re.search(r'version (\d+)', said)
    return int(version.group(1)) if version else None


def tidy(changed=False):
    """run-clang-tidy over the libraries that need no ROS. Several sources at a time, as their common headers take longest; or, one
    at a time, those that have changed."""
    folder = os.path.join(SPACE, 'build', 'lint_changed' if changed else 'lint')
    made = subprocess.run(['cmake', '-S', ROOT, '-B', folder, '-DHIDWA_ROS=OFF', '-DHIDWA_TESTS=OFF', '-DHIDWA_TOOLS=ON',
                           f'-DHIDWA_UNITY={"OFF" if changed else "ON"}',
                           '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON'], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if made.returncode:
        return ['sh', '-c', 'printf "%s\\n" "$0"; exit 1', made.stdout]
    shutil.copy(os.path.join(ROOT, '.clang-tidy'), folder)  # it is looked for above the files, which lie in this folder
    command = ['run-clang-tidy', '-p', folder, '-quiet', '-j', str(os.cpu_count() or 1)]
    if not changed:
        return command
    sources = changed_sources()
    return [*command, *(f'{re.escape(os.path.join(ROOT, path))}$' for path in sources)] if sources else ['true']


# How each tool is called, made when it runs.
TOOLS = {
    'clang-format': lambda: ['clang-format', '--dry-run', '-Werror', *files('*.cpp', '*.hpp')],
    'clang-tidy': tidy,
    'cppcheck': lambda: ['cppcheck', '--enable=warning,performance,portability', '--suppress=duplicateAssignExpression',
                         '--suppress=useInitializationList', '--inline-suppr', '--quiet', '--error-exitcode=1', '--std=c++17',
                         '-I', 'include', '-j', str(os.cpu_count() or 1), 'src', 'lab',
                         *(path for path in (f'compat/{name}/src' for name in COMPAT) if os.path.isdir(os.path.join(ROOT, path)))],
    'flake8': lambda: ['flake8', 'scripts', 'console', 'test'],
    'shellcheck': lambda: ['shellcheck', '-x', '-e', 'SC1091', *shell_scripts()],
    'codespell': lambda: ['codespell', '-L', WORDS, *files('*.md', '*.rst', '*.hpp', '*.cpp', '*.py', '*.yaml', '*.launch', '*.msg')],
    'grep': lambda: ['sh', '-c', '! grep -nE "$0" "$@" /dev/null', DIALECT, *files('src/*.[ch]pp', 'lab/*.[ch]pp', 'include/*.hpp')],
    'catkin_lint': lambda: ['env', 'HIDWA_WITH_TOOLS=1', 'catkin_lint', '--offline', '-W0', '.',
                            *(os.path.join('compat', name) for name in COMPAT)],
}


def left_out(name):
    """Why a tool cannot be run; empty where it can."""
    if not shutil.which(name):
        return 'not installed'
    if name.startswith('clang-') and version_of(name) != CLANG:
        return f'version {CLANG} is needed, this one finds other things'
    if name == 'clang-tidy' and not shutil.which('cmake'):
        return 'cmake is not installed'
    return ''


def lint(only=(), changed=False):
    """Runs the tools: (ran well, found something, left out), each a list of names; what they found is printed. `changed`: of the
    sources, clang-tidy looks only at those that have changed."""
    well, found, out = [], [], []
    for name, command in TOOLS.items():
        if only and name not in only:
            continue
        reason = left_out(name)
        if reason:
            print(f'{name}: left out: {reason}')
            out.append(name)
            continue
        words = tidy(True) if changed and name == 'clang-tidy' else command()
        run = subprocess.run(words, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        print(f'{name}: {"ok" if run.returncode == 0 else "found something"}', flush=True)
        if run.returncode:
            print('\n'.join(run.stdout.splitlines()[:60]))
        (found if run.returncode else well).append(name)
    return well, found, out


def main(arguments=None):
    """scripts/lint"""
    parser = argparse.ArgumentParser(
        prog='scripts/lint', description='Installs what is missing and runs the tools that hold the style: ' + ', '.join(TOOLS) + '.',
        epilog='exit status: 0 nothing found; 1 something was; 77 no tool could be run\n'
        'scripts/lint --format mends what clang-format finds')
    parser.add_argument('tools', nargs='*', metavar='TOOL', help='only these')
    parser.add_argument('--changed', action='store_true',
                        help='clang-tidy looks only at sources that differ from upstream (where none does: from the commit before)')
    parser.add_argument('--format', action='store_true', help='run clang-format over all C++ and nothing else')
    options = parser.parse_args(arguments)
    for name in options.tools:
        if name not in TOOLS:
            parser.error(f"there is no '{name}'; there are {', '.join(TOOLS)}")
    if options.format:
        if left_out('clang-format'):
            print(f"scripts/lint: clang-format: {left_out('clang-format')}", file=sys.stderr)
            return 1
        return subprocess.run(['clang-format', '-i', *files('*.cpp', '*.hpp')], cwd=ROOT, check=False).returncode
    well, found, _ = lint(options.tools, options.changed)
    return 1 if found else 0 if well else LEFT_OUT


if __name__ == '__main__':
    sys.exit(main())
