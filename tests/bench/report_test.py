"""Tests of report.py and of scripts/bench --compare."""

import json
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, HERE)
import report  # noqa: E402


def cost(name, ratio):
    return {'name': name, 'value': 3 * ratio, 'unit': 'us', 'better': 'less',
            'baseline': 'b', 'baseline_value': 3, 'ratio': ratio}


def speed(name, ratio, **more):
    return dict(cost(name, ratio), better='more', **more)


class ReportTest(unittest.TestCase):
    def test_says_worse_for_a_cost_that_grows_and_a_speed_that_shrinks(self):
        old = [cost('a', 1.0), speed('s', 1.0), cost('same', 2.0)]
        for new, name in (([cost('a', 1.2), speed('s', 1.0)], 'a'),
                          ([cost('a', 1.0), speed('s', 0.8)], 's')):
            lines, is_worse = report.compare(old, new)
            self.assertTrue(is_worse)
            self.assertEqual(len(lines), 1)
            self.assertIn(f'WORSE   {name}: ', lines[0])

    def test_the_other_direction_is_better(self):
        lines, is_worse = report.compare([cost('a', 1.2), speed('s', 0.8)],
                                         [cost('a', 1.0), speed('s', 1.0)])
        self.assertFalse(is_worse)
        self.assertEqual([line[:6] for line in lines], ['better', 'better'])

    def test_noise_is_no_difference(self):
        lines, is_worse = report.compare([cost('a', 1.0)], [cost('a', 1.14)])
        self.assertFalse(is_worse)
        self.assertIn('no difference', lines[0])

    def test_a_figure_that_was_zero_and_is_not(self):
        old = [{'name': 'lost', 'value': 0, 'unit': 'n', 'better': 'less'}]
        new = [{'name': 'lost', 'value': 1, 'unit': 'n', 'better': 'less'}]
        self.assertTrue(report.compare(old, new)[1])
        self.assertFalse(report.compare(new, old)[1])

    def test_what_is_compared_is_the_ratio(self):
        slow_machine = dict(cost('a', 1.0), value=300, baseline_value=300)
        self.assertFalse(report.compare([cost('a', 1.0)], [slow_machine])[1])

    def test_growth_is_measured_by_the_smallest_size_of_its_series(self):
        rows = [{'series': s, 'grows': 'objects', 'size': n, 'seconds': t}
                for s, n, t in (('plan', '5', '0.002'), ('plan', '10', '0.01'),
                                ('learn', '5', '0.5'), ('learn', '10', '1'))]
        figures = report.figures_of_growth(rows)
        self.assertEqual([(f['name'], f['baseline'], f['ratio'])
                          for f in figures],
                         [('growth: plan, 10 objects',
                           'growth: plan, 5 objects', 5.0),
                          ('growth: learn, 10 objects',
                           'growth: learn, 5 objects', 2.0)])

    def test_reads_lines_among_others(self):
        figures = report.figures_of_lines(
            'hello\n{"figure": "x", "value": 3, "unit": "us", "better": "less",'
            ' "baseline": "y", "baseline_value": 2}\n')
        self.assertEqual(figures, [
            {'name': 'x', 'value': 3, 'unit': 'us', 'better': 'less',
             'baseline': 'y', 'baseline_value': 2, 'ratio': 1.5}])

    def test_reads_google_benchmark(self):
        def run(name, time, unit, **more):
            return dict(name=name, cpu_time=time, time_unit=unit, **more)
        text = json.dumps({'benchmarks': [
            run('Raw/1', 2, 'us'), run('Frame/1', 3, 'ms'),
            run('Items/real_time', 1, 'us', items_per_second=5e5)]})
        figures = report.figures_of_google(text, [(r'Frame/(.)', r'Raw/\1'),
                                                  ('Items', 'Raw/1')])
        self.assertEqual([(f['name'], f['ratio']) for f in figures],
                         [('Frame/1', 1500.0), ('Items', 1.0)])

    def test_the_table_marks_missed_goals(self):
        text = report.table([speed('fast', 0.8, goal=0.75),
                             speed('slow', 0.7, goal=0.75)])
        _, fast, slow = text.splitlines()
        self.assertNotIn('MISSED', fast)
        self.assertIn('>= 0.75  MISSED', slow)


class CompareTest(unittest.TestCase):
    def compare(self, old, new):
        with tempfile.TemporaryDirectory() as folder:
            paths = []
            for name, figures in (('old', old), ('new', new)):
                paths.append(os.path.join(folder, name))
                with open(paths[-1], 'w', encoding='utf-8') as file:
                    json.dump({'figures': figures}, file)
            return subprocess.run(
                [os.path.join(HERE, '../../scripts/bench'), '--compare',
                 paths[0], '--with', paths[1]],
                capture_output=True, text=True, check=False)

    def test_exits_with_1_when_worse(self):
        result = self.compare([cost('a', 1.0)], [cost('a', 1.5)])
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn('WORSE   a: 1 -> 1.5', result.stdout)

    def test_exits_with_0_when_not(self):
        result = self.compare([cost('a', 1.5)], [cost('a', 1.0)])
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('better  a: 1.5 -> 1', result.stdout)

    def test_names_a_file_that_is_none(self):
        result = subprocess.run(
            [os.path.join(HERE, '../../scripts/bench'), '--compare',
             '/nowhere.json'], capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 2)
        self.assertIn('/nowhere.json', result.stderr)


if __name__ == '__main__':
    unittest.main()
