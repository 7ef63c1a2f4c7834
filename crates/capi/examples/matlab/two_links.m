% Effective mass of a planar arm with two hinges (models/planar_2r.urdf) at many configurations: by the C interface, and by the mass
% matrix of the comment in that file.
%
%   octave two_links.m MODEL        in the folder of percuss_mass.mex
given = argv ();
rand ("seed", 1);
q = 2 * pi * (rand (1000, 2) - 0.5);
m = percuss_mass (given{end}, "outer", [0.4, 0, 0], [0, 1, 0], q);

% M = [a + b + 2c + A1, b + c; b + c, b + A2]; the normal is that of the outer link, so that j = [l1 cos(q2) + l2, l2].
a = 4 * 0.5^2 / 3 + 2 * 0.5^2;
b = 2 * 0.4^2 / 3;
expected = zeros (rows (q), 1);
for k = 1:rows (q)
  c = 2 * 0.5 * 0.4 / 2 * cos (q(k, 2));
  M = [a + b + 2 * c + 0.3, b + c; b + c, b + 0.1];
  j = [0.5 * cos(q(k, 2)) + 0.4, 0.4];
  expected(k) = 1 / (j * (M \ j'));
end
% Condition numbers of M up to some ten.
worst = max (abs (m ./ expected - 1));
printf ("%d configurations, %.6f to %.6f kg, largest relative difference %.1e\n", rows (q), min (m), max (m), worst);
assert (worst < 1e-13);

% An error of percuss is an error here.
try
  percuss_mass (given{end}, "no link", [0, 0, 0], [0, 1, 0], q);
  error ("an unknown link was accepted");
catch problem
  assert (! isempty (strfind (problem.message, "no link")));
end
