-- A cube of Schwarz P cells.
return intersection(box(30, 30, 30), schwarz_p(10, 1.2))
