(define (problem test-04)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 b7 b8 - block)
  (:init
    (hand-empty) (on-table b8) (on-table b7) (on-table b4) (on-table b6)
    (on-table b2) (clear b3) (clear b5) (clear b4) (clear b6) (clear b2)
    (on b1 b8) (on b3 b1) (on b5 b7))
  (:goal (and
    (on b4 b6) (on b5 b4) (on b7 b5) (on b8 b7) (on b3 b8))))
