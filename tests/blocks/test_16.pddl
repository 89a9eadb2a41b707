(define (problem test-16)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 b7 b8 - block)
  (:init
    (hand-empty) (on-table b3) (on-table b2) (on-table b8) (on-table b5)
    (clear b4) (clear b2) (clear b7) (clear b5) (on b4 b3) (on b1 b8)
    (on b6 b1) (on b7 b6))
  (:goal (and
    (on b4 b6) (on b2 b7) (on b8 b1))))
