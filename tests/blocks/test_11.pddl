(define (problem test-11)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 b7 - block)
  (:init
    (hand-empty) (on-table b1) (on-table b2) (on-table b7) (on-table b6)
    (clear b5) (clear b2) (clear b4) (clear b6) (on b3 b1) (on b5 b3)
    (on b4 b7))
  (:goal (and
    (on b1 b3) (on b4 b1) (on b6 b2))))
