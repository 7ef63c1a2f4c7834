"""Generated C code of the shipped models, and of robots if a folder is given: compiled by gcc and clang as C99 and C++ without warnings,
then its self-test (values of percuss) under the sanitizers of undefined behaviour and of addresses, and for some under valgrind.

    generated_code.py PERCUSS [ROBOTS [COUNT]]

ROBOTS: a folder with URDF files, such as that of example-robot-data; at most COUNT of them."""
import json, os, shutil, subprocess, sys, tempfile

WARNINGS = ['-Wall', '-Wextra', '-Wconversion', '-Werror']
SANITIZERS = ['-fsanitize=undefined,address', '-fno-sanitize-recover=all']
# Contacts and mechanisms for which no code exists.
REFUSALS = ['no motion of the mechanism', 'a motion without mass', 'moves no mass', 'would have', 'branches of the loops cross']


def models(root, robots, count):
    found = [os.path.join(root, 'models', f) for f in sorted(os.listdir(os.path.join(root, 'models'))) if f.endswith('.urdf')]
    if robots:
        files = sorted(os.path.join(d, f) for d, _, names in os.walk(robots) for f in names if f.endswith('.urdf'))
        found += files[::max(1, len(files)//count)][:count]
    return found


def run(arguments, folder=None):
    done = subprocess.run(arguments, cwd=folder, capture_output=True, text=True, timeout=600)
    return done.returncode, done.stdout + done.stderr


def sanitizers(compiler):
    """Flags of the sanitizers, none if their libraries are not installed."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, 'a.c'), 'w') as file:
            file.write('int main(void) { return 0; }\n')
        code, _ = run([compiler, *SANITIZERS, 'a.c', '-o', 'a'], folder)
    if code != 0:
        print('%s has no libraries of the sanitizers: compiled without them' % compiler)
    return SANITIZERS if code == 0 else []


def main():
    percuss = os.path.abspath(sys.argv[1])
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..')
    robots, count = sys.argv[2] if len(sys.argv) > 2 else None, int(sys.argv[3]) if len(sys.argv) > 3 else 20
    compilers = [c for c in (('gcc', 'g++'), ('clang', 'clang++')) if shutil.which(c[0])]
    if len(compilers) < 2:
        print('clang is not installed: only gcc compiles')
    checks = {c: sanitizers(c) for c, _ in compilers}
    passed = failed = refused = 0
    for number, model in enumerate(models(root, robots, count)):
        code, text = run([percuss, 'check', model, '--format', 'json'])
        if code != 0:
            continue
        start = text.index('{')
        report = json.JSONDecoder().raw_decode(text[start:])[0]
        link = report['links'][-1]['name']
        loops = bool(report.get('closures'))
        with tempfile.TemporaryDirectory() as folder:
            flags = ['--velocity', '--gradient', '--mobility', '--batch'] + (['--close'] if loops else [])
            code, text = run([percuss, 'generate', model, '--link', link, '--point', '0.03,-0.02,0.05', '--normal', '0.3,-0.5,0.8',
                              '--name', 'm', '-o', folder] + flags)
            if code == 2 and any(reason in text for reason in REFUSALS):
                refused += 1
                continue
            problems = [] if code == 0 else [text]
            for c, cpp in compilers if code == 0 else []:
                steps = [[c, '-std=c99', '-O1', *WARNINGS, *checks[c], 'm.c', 'm_test.c', '-lm', '-o', 'test'], ['./test'],
                         [cpp, '-std=c++11', '-x', 'c++', '-O0', *WARNINGS, '-c', 'm.c', '-o', 'm.o'],
                         [c, '-std=c99', '-O3', *WARNINGS, 'm.c', 'm_test.c', '-lm', '-o', 'fast'], ['./fast']]
                if number % 5 == 0 and shutil.which('valgrind'):
                    steps.append(['valgrind', '-q', '--error-exitcode=9', './fast'])
                for step in steps:
                    code, text = run(step, folder)
                    if code != 0:
                        problems.append('%s: %s' % (' '.join(step), text[-600:]))
                        break
            if problems:
                failed += 1
                print('%s: %s' % (model, problems[0]))
            else:
                passed += 1
    print('%d contacts without code (immovable or massless)' % refused)
    print('generated code: %d passed, %d failed' % (passed, failed))
    sys.exit(1 if failed or passed < 10 else 0)


main()
