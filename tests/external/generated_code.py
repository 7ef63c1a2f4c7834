"""Generated C code of the shipped models, and of robots if a folder is given: compiled by gcc and clang as C99 and C++ without warnings,
then its self-test (values of percuss) under the sanitizers of undefined behaviour and of addresses, and for some under valgrind. The code
of trees is also called at random configurations and compared with Pinocchio.

    generated_code.py PERCUSS [ROBOTS [COUNT]]

ROBOTS: a folder with URDF files, such as that of example-robot-data; at most COUNT of them."""
import ctypes, json, os, random, re, shutil, subprocess, sys, tempfile
import xml.etree.ElementTree as ElementTree
import numpy as np
import pinocchio

POINT, NORMAL = np.array([0.03, -0.02, 0.05]), np.array([0.3, -0.5, 0.8])
CONFIGURATIONS = 20
# Relative to 1/m of a unit speed of every joint: both programs round M and its inverse.
DIFFERENCE = 1e-9
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


def peer_mass(model, robot, link, positions, mimics):
    """1/(j M⁻¹ jᵀ) by Pinocchio for positions by joint; mimicking joints follow by a matrix of rates."""
    q, rates = pinocchio.neutral(robot), np.zeros((robot.nv, len(positions)))
    columns = {name: column for column, name in enumerate(positions)}
    for i, name in enumerate(robot.names):
        if i == 0:
            continue
        master, factor, offset = mimics.get(name, (name, 1.0, 0.0))
        if master not in positions:
            return None
        joint, value = robot.joints[i], factor*positions[master] + offset
        q[joint.idx_q:joint.idx_q + joint.nq] = [np.cos(value), np.sin(value)] if joint.nq == 2 else [value]
        rates[joint.idx_v, columns[master]] = factor
    data = robot.createData()
    mass = np.reshape(pinocchio.crba(robot, data, q), (robot.nv, robot.nv))
    mass = np.triu(mass) + np.triu(mass, 1).T
    pinocchio.forwardKinematics(robot, data, q)
    frame = robot.getFrameId(link, pinocchio.FrameType.BODY)
    own = np.reshape(pinocchio.computeFrameJacobian(robot, data, q, frame, pinocchio.ReferenceFrame.LOCAL), (6, robot.nv))
    normal = NORMAL/np.linalg.norm(NORMAL)
    row = (normal @ own[:3] + np.cross(POINT, normal) @ own[3:]) @ rates
    mass = rates.T @ mass @ rates
    return 1/(row @ np.linalg.solve(mass, row))


def peer_problem(model, link, folder):
    """First difference between the generated code of a tree and Pinocchio; None without one. The number of compared configurations."""
    try:
        robot = pinocchio.buildModelFromUrdf(model)
    except Exception:
        return None, 0
    if not robot.existFrame(link, pinocchio.FrameType.BODY) or any(joint.nv > 1 for joint in robot.joints[1:]):
        return None, 0
    header = open(os.path.join(folder, 'm.h')).read()
    names = re.findall(r'q\[\d+\]\s+\w+ joint "(.*?)"', header)
    mimics = {}
    for joint in ElementTree.parse(model).getroot().findall('joint'):
        mimic, dynamics = joint.find('mimic'), joint.find('dynamics')
        # URDF+ has the inertia of a rotor, which Pinocchio's reader leaves out.
        if dynamics is not None and 'armature' in dynamics.attrib:
            robot.armature[robot.joints[robot.getJointId(joint.get('name'))].idx_v] = float(dynamics.get('armature'))
        if mimic is not None:
            mimics[joint.get('name')] = (mimic.get('joint'), float(mimic.get('multiplier', 1)), float(mimic.get('offset', 0)))
    code, text = run(['gcc', '-std=c99', '-O2', '-shared', '-fPIC', 'm.c', '-lm', '-o', 'm.so'], folder)
    if code != 0:
        return text, 0
    function = ctypes.CDLL(os.path.join(folder, 'm.so')).m_mass
    generator, compared = random.Random(7), 0
    for _ in range(CONFIGURATIONS):
        q = [generator.uniform(-3, 3) for _ in names]
        expected = peer_mass(model, robot, link, dict(zip(names, q)), mimics)
        if expected is None or not np.isfinite(expected):
            continue
        mass = ctypes.c_double()
        status = function((ctypes.c_double*len(q))(*q), ctypes.byref(mass))
        if status != 0 or not abs(mass.value/expected - 1) < DIFFERENCE:
            return 'status %d, %.12g kg, Pinocchio %.12g kg at %s' % (status, mass.value, expected, q), compared
        compared += 1
    return None, compared


def main():
    percuss = os.path.abspath(sys.argv[1])
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..')
    robots, count = sys.argv[2] if len(sys.argv) > 2 else None, int(sys.argv[3]) if len(sys.argv) > 3 else 20
    compilers = [c for c in (('gcc', 'g++'), ('clang', 'clang++')) if shutil.which(c[0])]
    if len(compilers) < 2:
        print('clang is not installed: only gcc compiles')
    checks = {c: sanitizers(c) for c, _ in compilers}
    passed = failed = refused = compared = 0
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
            code, text = run([percuss, 'generate', model, '--link', link, '--point', ','.join(map(str, POINT)), '--normal', ','.join(map(str, NORMAL)),
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
            if not problems and not loops:
                problem, count_here = peer_problem(model, link, folder)
                compared += count_here
                problems += [] if problem is None else [problem]
            if problems:
                failed += 1
                print('%s: %s' % (model, problems[0]))
            else:
                passed += 1
    print('%d contacts without code (immovable or massless)' % refused)
    print('%d configurations of trees compared with Pinocchio' % compared)
    print('generated code: %d passed, %d failed' % (passed, failed))
    sys.exit(1 if failed or passed < 10 or (robots and compared < 100) else 0)


main()
