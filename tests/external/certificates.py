"""Proofs of `percuss extremes --certify` and `percuss safe-speed --certify`, checked by docs/explanation/check_certificate.py, which does not use percuss; altered proofs must
be rejected. Sines and cosines of the checker are compared with mpmath, if it is installed.

    certificates.py PERCUSS"""
import copy, importlib.util, json, os, random, subprocess, sys, tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..')
CHECKER = os.path.join(ROOT, 'docs', 'explanation', 'check_certificate.py')
QUESTIONS = [
    ['six_r_arm.urdf', '--link', 'tool', '--point', '0,0,0', '--normal', '0,0,-1', '--normal-frame', 'world', '--range', 'shoulder=-40deg:-20deg',
     '--range', 'elbow=50deg:70deg', '--range', 'wrist_pitch=30deg:60deg', '--mass-tolerance', '20%'],
    ['planar_2r.urdf', '--link', 'outer', '--point', '0.4,0,0', '--normal', '0,1,0', '--range', 'elbow=30deg:150deg'],
    ['six_r_arm.urdf', '--link', 'tool', '--point', '0,0,0', '--normal', '0,0,-1', '--normal-frame', 'world', '--range', 'elbow=50deg:60deg',
     '--normals', 'cone:5deg', '--edge', '0,0,0.02'],
    ['six_r_arm.urdf', '--link', 'tool', '--point', '0,0,0', '--normal', '0,0,-1', '--range', 'elbow=50deg:60deg', '--normals', 'cone:5deg'],
    ['double_pendulum.urdf', '--link', 'lower', '--about-axis', '0,1,0', '--range', 'elbow=20deg:70deg'],
]


def narrower(report, side, end, factor):
    if report['certificate'][side]:
        report['certificate'][side][end] *= factor


def heavier(report, factor):
    """Mass and moments of all bodies."""
    for row in report['certificate']['tree']['bodies']:
        row[36:] = [x * factor for x in row[36:]]


def wider(report):
    report['certificate']['tree']['ranges'][0][2] += 0.5


def uncovered(report):
    """Omits the last box of the divisions."""
    report['certificate']['most']['divisions'].pop()


def moved(report):
    """Moves the contact point of a force."""
    row = report['certificate']['tree']['contact']
    row[3:9] = [x if row[1] else 1.2 * x + 0.03 for x in row[3:9]]


def elsewhere(report, side):
    """States the other end of the first range for the best positions."""
    _, lower, upper = report['certificate']['tree']['ranges'][0]
    best = (report['certificate'][side] or {'positions': [0]})['positions']
    best[0] = lower if best[0] > 0.5 * (lower + upper) else upper


def longer(report):
    """Moves the joint frames away from their parents."""
    for row in report['certificate']['tree']['bodies']:
        row[30:36] = [1.1 * x for x in row[30:36]]


def outside(report):
    report['certificate']['most']['positions'][0] += 10.0


ALTERATIONS = {
    'another contact point': moved,
    'other positions of the largest m̄': lambda report: elsewhere(report, 'most'),
    'other positions of the smallest m̄': lambda report: elsewhere(report, 'least'),
    'longer links': longer,
    'positions outside the ranges': outside,
    'a range as the division of a sufficient box': lambda report: report['certificate']['most']['divisions'].insert(0, 0),
    'a smaller upper bound of the largest m̄': lambda report: narrower(report, 'most', 'upper', 0.97),
    'a larger lower bound of the largest m̄': lambda report: narrower(report, 'most', 'lower', 1.03),
    'a larger lower bound of the smallest m̄': lambda report: narrower(report, 'least', 'lower', 1.03),
    'a smaller upper bound of the smallest m̄': lambda report: narrower(report, 'least', 'upper', 0.97),
    'heavier bodies': lambda report: heavier(report, 1.05),
    'lighter bodies': lambda report: heavier(report, 0.95),
    'a wider range': wider,
    'a missing box': uncovered,
    'a larger tolerance of the masses': lambda report: report['certificate'].update(mass_tolerance=report['certificate']['mass_tolerance'] + 0.05),
}


SURFACES = [
    ['shaped_arm.urdf', '--link', 'finger', '--point', '0,0,0', '--normal', '0,0,1', '--region', 'chest', '--force', '280', '--surface',
     '--range', 'elbow=50deg:70deg', '--range', 'shoulder=-10deg:10deg'],
]


def check(report, folder):
    path = os.path.join(folder, 'report.json')
    with open(path, 'w') as file:
        json.dump(report, file)
    done = subprocess.run([sys.executable, CHECKER, path], capture_output=True, text=True, timeout=600)
    return done.returncode, done.stdout + done.stderr


def sines(count):
    """Number of sines and cosines of the checker that were compared with 60 digits."""
    try:
        import mpmath
    except ImportError:
        return 0
    spec = importlib.util.spec_from_file_location('check_certificate', CHECKER)
    checker = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(checker)
    mpmath.mp.dps = 60
    generator = random.Random(3)
    for _ in range(count):
        x = generator.uniform(-1, 1) * 10 ** generator.uniform(-8, 3)
        for found, exact in zip(checker.sin_cos_at(x), (mpmath.sin(x), mpmath.cos(x))):
            assert found.lo <= exact <= found.hi and found.hi - found.lo < 4e-16, x
    return count


def main():
    percuss, failures = sys.argv[1], []
    with tempfile.TemporaryDirectory() as folder:
        questions = [('extremes', question + ['--starts', '4']) for question in QUESTIONS]
        for name, question in questions + [('safe-speed', question) for question in SURFACES]:
            model = os.path.join(ROOT, 'models', question[0])
            command = [percuss, name, model, *question[1:], '--certify', '2%', '--format', 'json']
            report = json.loads(subprocess.run(command, capture_output=True, text=True, check=True, timeout=600).stdout)
            report = report if 'certificate' in report else report['proved']
            code, said = check(report, folder)
            print(question[0], said.strip())
            if code != 0:
                failures.append(f'{question[0]}: {said}')
            for name, alter in ALTERATIONS.items():
                altered = copy.deepcopy(report)
                alter(altered)
                if altered != report and check(altered, folder)[0] == 0:
                    failures.append(f'{question[0]}: {name} is accepted')
    print(f'{sines(20_000)} sines and cosines agree with mpmath')
    print('\n'.join(failures) or 'all proofs are checked, all alterations are rejected')
    sys.exit(bool(failures))


if __name__ == '__main__':
    main()
