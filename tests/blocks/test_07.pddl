(define (problem test-07)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 b7 - block)
  (:init
    (hand-empty) (on-table b7) (on-table b4) (on-table b2) (clear b5)
    (clear b4) (clear b1) (on b3 b7) (on b6 b3) (on b5 b6) (on b1 b2))
  (:goal (and
    (on b4 b1) (on b2 b4) (on b6 b7) (on b3 b6) (on b5 b3))))
